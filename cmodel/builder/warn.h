/* warn.h - what build says of a scene that it takes, but that the picture shows otherwise
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each appends a line to report->warning, or nothing.
 */
#ifndef SPH_BUILD_WARN_H
#define SPH_BUILD_WARN_H

#include "builder/build.h"
#include "builder/grid/facets.h"

/* Spheres of few grid units, and the profile under which they are rounder. */
void sph_warn_coarse(const struct sph_scene *scene, const struct sph_profile *profile, int axes,
                     struct sph_build_report *report);

/* An eye that is put nearer. */
void sph_warn_eye(const struct sph_scene *scene, const struct sph_machine *machine,
                  struct sph_build_report *report);

/* Notes in the ledger triangles that are left out: without area on the grid, or twice in the scene
 * or on the grid. -1 under `strict`. */
int sph_note_left_out(const struct sph_scene *scene, const struct sph_facets *facets,
                      struct sph_build_report *report, struct sph_error *err);

/* The same of the images of the scene: what they were decoded from. mips may be NULL. */
int sph_note_images(const struct sph_scene *scene, const struct sph_mip *mips,
                    struct sph_ledger *ledger, struct sph_error *err);

/* The same of lights and ambient light beyond what registers hold. */
int sph_note_limited(const struct sph_scene *scene, struct sph_build_report *report,
                     struct sph_error *err);

/* Planes that the frame sees beyond the machine's grid; sets report->cut. -1 with a message if
 * memory is out. */
int sph_warn_cut(const struct sph_scene *scene, const struct sph_machine *machine,
                 struct sph_build_report *report, struct sph_error *err);

#endif
