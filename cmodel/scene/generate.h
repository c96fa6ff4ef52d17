/* generate.h - scenes made by formula
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_GENERATE_H
#define SPH_SCENE_GENERATE_H

#include "scene/scene.h"

struct sph_generate_options {
    int size;          /* sphereflake, icosphere, jacks and so on: 1 to 5; 0 means 2 */
    uint32_t n;        /* random, swarm, scenarios: spheres, 1 to SPH_MAX_SPHERES; 0 means 1000,
                          4096, 64 */
    uint64_t seed;     /* paper5, paper100, random, scenario2, 3: another choice of spheres */
    double radius;     /* scenarios; 0 means 1 */
    int plain;         /* scenarios: materials without highlights and Whitted's sum */
    double drift;      /* scene units a frame of every sphere, polygon and cone, up to
                          SPH_NUMBER_MAX; 0: they are still, of swarm 0.1 */
    double orbit;      /* degrees a frame of the camera, up to one turn; 0: it is still */
    int width, height; /* resolution; 0 means 320 x 180, scenarios 640 x 1088 */
};

/* One line of text for every kind, for help: "sphereflake  ...\n...". */
extern const char sph_generate_help[];

/* The option that a number behind a kind stands for, as in sphereflake:3. */
enum { SPH_TAKES_NOTHING, SPH_TAKES_SIZE, SPH_TAKES_N, SPH_TAKES_SEED, SPH_TAKES_UNKNOWN };
int sph_generate_takes(const char *kind);

/* Whether a text is KIND:N, or a KIND that takes no number: `kind` of 32 characters and options
 * then say which. 1 if so, 0 if not, -1 with a message if N is out of range. */
int sph_generate_parse(const char *text, char kind[32], struct sph_generate_options *options,
                       struct sph_error *err);

/* Makes the scene of the given kind:
 *   sphereflake      9^0 + ... + 9^size mirrored spheres: the SPD scene `balls` without floor
 *   paper5, paper100 Borodavka 2015, Fig. 10 and 12: random spheres that fill the screen,
 *                    one light, mirror weight 0.3, eye on +z looking along -z
 *   interpenetrating spheres that cut each other
 *   random           n spheres in a cube, as dense for every n
 *   swarm            the same spheres, each moving its own way
 *   huge_tiny        one huge sphere under small and tiny ones (radii 1000 to 0.02)
 *   icosphere        20 * 4^size triangles, a closed mesh, over a plane
 *   scenario1, 2, 3  Aroxa 2014, IV.B: n spheres in a cube over a plane, in a lattice, in the
 *                    corners at random, or half and half
 *   jacks, lattice, tree, rings
 *                    cones, cylinders and spheres, in the manner of SPD's scenes of these names
 *   balls, mount, tetra, shells
 *                    likewise: sphereflake with a floor, a mountain of 2 * 4^(size+2) triangles,
 *                    4^size tetrahedra, size spirals of 48 spheres
 *   cover            about 480 spheres of radius 0.2 and three of radius 1 on one of radius 1000
 *   cornell          a room with a red and a green wall, two blocks, a light below the ceiling
 *   horizon          a ball above a plane that has no end
 * options may be NULL. No two spheres are the same. 0, or -1 with a message (unknown kind,
 * option out of range, no memory); then there is nothing to free. */
int sph_generate(const char *kind, const struct sph_generate_options *options,
                 struct sph_scene *scene, struct sph_error *err);

/* The scene that a command line or a caller means by a text: a file, or, if there is none of this
 * name, KIND or KIND:N as sph_generate_parse() reads it, of which all else is the default. options
 * are of files. 0, or -1 with a message. */
int sph_scene_find(const char *text, const struct sph_read_options *options,
                   struct sph_scene *scene, struct sph_error *err);

#endif
