/* generate_kinds.h - one function for each kind of generated scene; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each gets a scene of zero bytes with name, path and resolution set, and adds camera, lights,
 * materials and primitives. 0, or -1 with a message; sph_generate frees the scene then.
 */
#ifndef SPH_SCENE_GENERATE_KINDS_H
#define SPH_SCENE_GENERATE_KINDS_H

#include "scene/edit.h"
#include "scene/generate.h"

int sph_make_sphereflake(const struct sph_generate_options *options, struct sph_scene *scene,
                         struct sph_error *err);
int sph_make_paper5(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err);
int sph_make_paper100(const struct sph_generate_options *options, struct sph_scene *scene,
                      struct sph_error *err);
int sph_make_interpenetrating(const struct sph_generate_options *options, struct sph_scene *scene,
                              struct sph_error *err);
int sph_make_random(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err);
int sph_make_huge_tiny(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err);

int sph_make_icosphere(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err);

int sph_make_scenario1(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err);
int sph_make_scenario2(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err);
int sph_make_scenario3(const struct sph_generate_options *options, struct sph_scene *scene,
                       struct sph_error *err);

/* Sets what is made in motion, as options->drift and ->orbit say. -1 with a message. */
int sph_make_moving(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err);

/* Sets the eye, target, up direction and vertical field of view (degrees). */
void sph_make_camera(struct sph_scene *scene, struct sph_vec from, struct sph_vec at,
                     struct sph_vec up, double angle);

/* Adds SPH_PALETTE_SIZE materials with distinct, pleasant colours and the given highlight and
 * mirror weight; Kd is 1 - ks. -1 with a message if memory is short. */
#define SPH_PALETTE_SIZE 12
int sph_make_palette(struct sph_scene *scene, double ks, double shine, struct sph_error *err);

int sph_make_jacks(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);
int sph_make_lattice(const struct sph_generate_options *options, struct sph_scene *scene,
                     struct sph_error *err);
int sph_make_tree(const struct sph_generate_options *options, struct sph_scene *scene,
                  struct sph_error *err);
int sph_make_rings(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);

int sph_make_balls(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);
int sph_make_mount(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);
int sph_make_tetra(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);
int sph_make_shells(const struct sph_generate_options *options, struct sph_scene *scene,
                    struct sph_error *err);
int sph_make_cover(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err);
int sph_make_cornell(const struct sph_generate_options *options, struct sph_scene *scene,
                     struct sph_error *err);
int sph_make_horizon(const struct sph_generate_options *options, struct sph_scene *scene,
                     struct sph_error *err);

#endif
