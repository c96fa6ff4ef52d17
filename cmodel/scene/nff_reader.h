/* nff_reader.h - what the files that read NFF records share: the reader's state and its helpers
 * SPDX-License-Identifier: Apache-2.0
 *
 * nff_take.c takes numbers and vectors; nff_read.c camera and lights; nff_surface.c materials and
 * textures; scene/prim_NAME.c primitives.
 */
#ifndef SPH_SCENE_NFF_READER_H
#define SPH_SCENE_NFF_READER_H

#include "scene/edit.h"
#include "scene/nff_lex.h"

enum { SPH_SHADING_NFF, SPH_SHADING_BLEND, SPH_SHADING_SUM }; /* `shading`; NFF: no such word */

struct sph_reader {
    struct sph_lex lex;
    struct sph_scene *scene;
    int skip;          /* leave unsupported primitives out */
    double round;      /* of cones, see frustum.h */
    uint32_t material; /* the newest one of the file */
    int material_used; /* a primitive uses it */
    int shading;       /* SPH_SHADING_*: of the materials that follow */
    int ended;         /* the record has been noted in the ledger as the kind */
    enum sph_read kind;
    int clear;          /* `shadows clear`: shadow rays pass those that transmit */
    uint32_t texture;   /* of the spheres and planes that follow: index + 1, 0: none */
    uint32_t motion;    /* of the primitives that follow: index + 1, 0: still */
    uint32_t n_groups;  /* of facets so far */
    uint32_t view_line; /* of `v`, 0 if there was none; the same for `b` and `ambient` */
    uint32_t background_line, ambient_line;
    int plain[SPH_MAX_LIGHTS]; /* lights without colour of their own */
};

/* Starts a reader of an empty scene, and ends it: checks what can only be checked then, and gives
 * lights without colour theirs. Messages of the end name lex.path. */
void sph_nff_start(struct sph_reader *r, struct sph_scene *scene,
                   const struct sph_read_options *options);
int sph_nff_finish(struct sph_reader *r, struct sph_error *err);

/* An NFF file, which is closed. section: NULL, or which of its scenes, sph_scene_section(). On
 * failure *scene holds nothing to free. */
int sph_nff_read(FILE *file, const char *path, const char *section,
                 const struct sph_read_options *options, struct sph_scene *scene,
                 struct sph_error *err);

extern const char *const sph_nff_point[3];  /* "x", "y", "z" */
extern const char *const sph_nff_colour[3]; /* "red", "green", "blue" */

/* Takes n numbers with the given names. */
int sph_nff_numbers(struct sph_reader *r, const char *record, const char *const *names, int n,
                    double *values, struct sph_error *err);

int sph_nff_vec(struct sph_reader *r, const char *record, struct sph_vec *v, struct sph_error *err);

/* Takes n numbers with the given names if a number comes next. 1 if so, 0 if not, -1. */
int sph_nff_more(struct sph_reader *r, const char *record, const char *const *names, int n,
                 double *values, struct sph_error *err);

/* Marks the facets from this one on as of a record that counts as a kind. */
void sph_nff_mark(struct sph_reader *r, uint32_t facets, enum sph_read kind);

/* Notes in the ledger how the record of that line, or a part of it, ended. -1 under `strict`. */
int sph_nff_note(struct sph_reader *r, enum sph_read kind, uint32_t line, struct sph_error *err);

/* "file:line: `record`: what" at the newest word; -1. */
int sph_nff_fail(struct sph_reader *r, struct sph_error *err, const char *record, const char *what);

/* -1 with a message if one of the n values is not within 0..1. */
int sph_nff_check_unit(struct sph_reader *r, const char *record, const char *const *names, int n,
                       const double *values, struct sph_error *err);

/* What the numbers of a material, already in m, mean, with shares Ka and Kr: highlight,
 * transmission and index as NFF has them, which is Whitted's sum. One that has neither is left to
 * blend if its shares are no more than 1: that is the same, and less work. -1 under `strict`. */
int sph_nff_shade(struct sph_reader *r, const double share[2], struct sph_material *m,
                  struct sph_error *err);

/* The material of a primitive that is read: marks it as used. -1 with a message if there was no
 * `f` or `fm` yet; what: "sphere". */
int sph_nff_material(struct sph_reader *r, const char *record, const char *what, uint32_t *material,
                     struct sph_error *err);

/* Any record of NFF; its first word is next. In the ledger it is one of that kind if it has not
 * been noted otherwise. */
int sph_nff_take_record(struct sph_reader *r, struct sph_error *err);

/* One record each, its first word taken. */
int sph_nff_take_light(struct sph_reader *r, struct sph_error *err);
int sph_nff_take_f(struct sph_reader *r, struct sph_error *err);
int sph_nff_take_fm(struct sph_reader *r, struct sph_error *err);
int sph_nff_take_shading(struct sph_reader *r, struct sph_error *err);
int sph_nff_take_shadows(struct sph_reader *r, struct sph_error *err);
int sph_nff_take_texture(struct sph_reader *r, struct sph_error *err);

/* Takes the name of an image: path is the scene file's folder and the name; of AFF the folder of
 * the file that is read, or TextureFiles beside that folder, if the file is there alone. 1; 0 for
 * the bare word `none`; -1 with a message: the scene may not read it (inside.h), too. */
int sph_nff_image(struct sph_reader *r, const char *record, char path[512], struct sph_error *err);

/* Takes `srgb` or `linear` if one of them comes next: SPH_COLOURS_*. */
int sph_nff_colours(struct sph_reader *r, int *colours, struct sph_error *err);

/* The index + 1 of the texture that is equal but for the line; it is added if there is none. */
int sph_nff_find_texture(struct sph_reader *r, const struct sph_texture *texture, uint32_t *index,
                         struct sph_error *err);

#endif
