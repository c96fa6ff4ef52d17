/* scene.h - what the user wrote, in real numbers; the only part that knows file formats
 * SPDX-License-Identifier: Apache-2.0
 *
 * World frame as in the file: right-handed, any unit of length. Colours are linear 0..1.
 */
#ifndef SPH_SCENE_H
#define SPH_SCENE_H

#include <stdint.h>
#include <stdio.h>

#include "common/error.h"
#include "common/ledger.h"
#include "common/parallel.h"
#include "machine/layout.h" /* SPH_MAX_LIGHTS */
#include "texture/texel.h"  /* SPH_COLOURS_* */

#define SPH_MAX_TEXTURES 1024

struct sph_vec {
    double x, y, z;
};

/* A picture is one of columns x rows that are drawn for displays side by side; 0 x 0: it is alone.
 */
struct sph_wall {
    int columns, rows, column, row;
};

struct sph_camera {
    struct sph_vec from, at, up;
    double angle;    /* vertical field of view, degrees, 0 < angle < 180 (SPD convention) */
    double hither;   /* near distance; read, not used: spheres are never clipped */
    double shift[2]; /* of the picture's middle to the right of the view and above it, in heights of
                        the picture: window.h */
    int width, height;
    struct sph_wall wall; /* angle and shift are the wall's */
};

struct sph_light {
    struct sph_vec pos;
    double rgb[3]; /* 1/sqrt(number of lights) each where the file gives none */
    uint32_t line; /* of the file, for messages; 0 if generated */
};

/* Whitted's sum (docs/design/shading.md): then ks is the highlight alone, and shine, trans and ior
 * count.
 */
struct sph_sum {
    int on;        /* 0: nothing here counts */
    double ka, kr; /* ambient and mirror share */
    /* Of spheres (nesting.h): ior is that outside, inside is 1; index of what is around, 0: 1. */
    int hollow;
    double around;
    uint32_t of; /* index + 1 of the material that it is made of, 0: the file has it */
};

struct sph_material {
    double rgb[3];                    /* surface colour 0..1 */
    double kd, ks, shine, trans, ior; /* NFF `f`; ks is highlight and mirror weight */
    int line;                         /* of the file, for messages; 0 if generated */
    struct sph_sum sum;
    int passes; /* shadow rays pass what has it: `shadows clear`, and trans is not 0 */
};

struct sph_sphere {
    struct sph_vec ctr;
    double rad;
    uint32_t material; /* index into materials */
    uint32_t line;     /* of the file, for messages; 0 if generated */
    uint32_t texture;  /* index into textures + 1, 0: none */
    uint32_t motion;   /* index into motions + 1, 0: still */
};

/* A triangle, or a plane without end; both are seen from both sides and are called facets. */
struct sph_facet {
    int kind;            /* SPH_TRIANGLE, SPH_PLANE: not SPH_SPHERE */
    struct sph_vec v[3]; /* corners; plane: a point, the normal, the direction of s (any length) */
    int smooth;          /* n counts: of a triangle */
    struct sph_vec n[3]; /* normals at the corners, of any length but none */
    double st[3][2];     /* s, t at the corners; plane: [0] units of one repeat, [1] offset */
    uint32_t material;   /* index into materials */
    uint32_t texture;    /* index into textures + 1, 0: none */
    uint32_t motion;     /* index into motions + 1, 0: still */
    uint32_t group;      /* facets of one polygon have the same; from 0, rising */
    uint32_t frustum;    /* index into frusta + 1, 0: of none */
    uint32_t line;       /* of the file, for messages; 0 if generated */
    uint32_t read;       /* what its record counts as in the ledger, 0: not known */
};

/* What a ring of triangles was made of (frustum.h); a negative radius: seen from inside. */
struct sph_frustum {
    struct sph_vec base, apex;
    double base_rad, apex_rad;
    uint32_t line; /* of the file, for messages; 0 if generated */
};

/* An image and how it lies on spheres: longitude and latitude, poles along +-y, seam at -z. */
struct sph_texture {
    char path[512];   /* of the image: the folder of the scene file and the name given there */
    int colours;      /* SPH_COLOURS_* */
    int wrap[2];      /* of s and t: 0 repeats, 1 stays at the edge */
    double repeat[2]; /* spheres: repeats around, and from pole to pole */
    double offset[2]; /* spheres: repeats added */
    uint32_t line;    /* of the file, for messages; 0 if generated */
};

/* At frame n a point p is at  about + (1 + n * grow) * (p - about) + n * step. */
struct sph_motion {
    struct sph_vec step, about;
    double grow;
    uint32_t line; /* of the file, for messages; 0 if generated */
};

/* At that frame the camera is at `from` and looks at `at`. */
struct sph_flight {
    struct sph_vec from, at;
    uint32_t frame; /* at least 1 */
    uint32_t line;  /* of the file, for messages; 0 if generated */
};

struct sph_read_options {
    int skip_unsupported; /* leave out pb, ...: render the rest */
    int strict;           /* of ledger.h */
    double round;         /* of cones, see frustum.h; 0: SPH_FRUSTUM_ROUND */
    int allow_paths;      /* files that it names may lie anywhere: inside.h */
    uint32_t at;          /* frame that primitives and camera are moved to (motion.h, aff.h) */
    int timed;            /* of AFF: at this time, whatever the frame */
    double time;
    const char *camera;                  /* of a mesh: by name or number; NULL: the first */
    double radius;                       /* of points without one, see import.h */
    char up;                             /* of a mesh: 'x', 'y', 'z'; 0: as its format has it */
    const struct sph_progress *progress; /* NULL, or who is told how much of the file is read */
};

struct sph_scene {
    char name[128]; /* file name without folder and ending */
    char path[512]; /* as given, for messages */
    struct sph_camera camera;
    double background[3];
    double ambient[3];
    int n_lights;
    struct sph_light lights[SPH_MAX_LIGHTS];
    uint32_t n_materials, n_spheres;
    struct sph_material *materials;
    struct sph_sphere *spheres;
    uint32_t n_facets, n_textures;
    struct sph_facet *facets;
    struct sph_texture *textures;
    uint32_t n_motions, n_flights, n_frusta;
    struct sph_motion *motions;
    struct sph_flight *flights; /* by frame, rising: where the camera goes from frame 0 on */
    struct sph_frustum *frusta; /* as the file has them, not moved: for sph_scene_write() */
    struct sph_ledger ledger;   /* what became of each record */
    int allow_paths;            /* files that it names may lie anywhere: inside.h */
    int aff;                    /* read from AFF (aff.h), by these options */
    struct sph_read_options read;
    uint32_t n_files; /* what it includes, by path */
    char **files;
};

enum { SPH_SCENE_FILE = 4096 }; /* characters of a path, with the 0 behind it */

/* The file of a text that names a scene, and the name behind it: FILE:NAME is one of several scenes
 * of an NFF file. NULL, and the text itself as the file, if FILE is not there or all of it is. */
const char *sph_scene_section(const char *text, char file[SPH_SCENE_FILE]);

/* Reads an NFF file, one scene of it, or an AFF file by its name (docs/reference/scene_format.md),
 * into *scene. 0, or -1 with "file:line: ..." in *err; on failure *scene holds nothing to free. */
int sph_scene_read(const char *text, const struct sph_read_options *options,
                   struct sph_scene *scene, struct sph_error *err);

/* The same of a text of NFF in memory, of `length` bytes, which need no zero behind them. path: for
 * messages, and its folder is that of images. */
int sph_scene_parse(const char *text, size_t length, const char *path,
                    const struct sph_read_options *options, struct sph_scene *scene,
                    struct sph_error *err);

/* Writes the scene as NFF (round trip: every double survives). 0, or -1 with a message. */
int sph_scene_write(const struct sph_scene *scene, FILE *file, struct sph_error *err);

/* Triangles and planes that are of no cone, and cones: what is written. */
void sph_scene_count(const struct sph_scene *scene, uint32_t *facets, uint32_t *cones);

void sph_scene_free(struct sph_scene *scene);

#endif
