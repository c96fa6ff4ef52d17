/* gltf.h - what a glTF file says besides its triangles: materials, cameras, lights, extensions
 * SPDX-License-Identifier: Apache-2.0
 *
 * assimp gives the triangles where nodes put them. The rest is taken from the file's JSON, since
 * versions of assimp differ in what they make of fields of view, intensities and extensions, and
 * pass over what they do not know. Khronos, glTF 2.0 specification.
 */
#ifndef SPH_SCENE_GLTF_H
#define SPH_SCENE_GLTF_H

#include <jansson.h>

#include "scene/mesh.h"

struct sph_gltf {
    const char *path;
    json_t *root;
    uint64_t bin, bin_size; /* of GLB: where its binary part begins in the file, and its bytes */
};

/* What a surface looks like, whatever the format: shares 0..1 before the image multiplies rgb. */
struct sph_look {
    double rgb[3], kd, ks, kr; /* Ka is kd */
    double shine, trans, ior;
    char image[512];    /* path; empty: none */
    int coords;         /* which texture coordinates of the mesh */
    double place[2][3]; /* those of the image: place[.][0] u + place[.][1] v + place[.][2] */
};

/* Reads the JSON; -1 with a message: "file:line: " if it is none. Free with sph_gltf_close. */
int sph_gltf_open(struct sph_gltf *gltf, const char *path, struct sph_error *err);
void sph_gltf_close(struct sph_gltf *gltf);

/* Notes what is not used, refuses extensions that the file needs, and files that it names and that
 * are not there; skip: leaves images that are not there out. */
int sph_gltf_check(const struct sph_gltf *gltf, int skip, struct sph_scene *scene,
                   struct sph_error *err);

/* Material number `index`; that of the specification if there is none of this number. */
int sph_gltf_look(const struct sph_gltf *gltf, unsigned index, struct sph_look *look,
                  struct sph_scene *scene, struct sph_error *err);

/* Lights and the camera called `camera` (NULL: the first) by their nodes. middle, radius: of what
 * there is to see, which lights are weighed at. -1 with a message: no such camera, ... */
int sph_gltf_place(const struct sph_gltf *gltf, const char *camera, struct sph_vec middle,
                   double radius, struct sph_scene *scene, struct sph_error *err);

#endif
