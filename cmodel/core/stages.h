/* stages.h - the rays of one pixel stage by stage, in lines that model and RTL have alike
 * SPDX-License-Identifier: Apache-2.0
 *
 * A line is what one stage works with and what it gives, word for word as it stands in the wires. A
 * ray that somebody follows carries where its lines go (struct sph_ray), so each stage notes its
 * own numbers; the bench of the core notes those that it reads in the RTL (tb/core/stage_watch.h).
 * Widths and formats of all words stand in one table, in stages_text.c; docs/guide/simulation.md
 * has an example.
 */
#ifndef SPH_STAGES_H
#define SPH_STAGES_H

#include "core/frame.h"
#include "core/ray.h"
#include "machine/machine.h"
#include "math/fx.h"

/* In the order in which a ray comes to them; NODE to KEY belong to a visit. */
enum {
    SPH_STAGE_RAY,    /* set-up */
    SPH_STAGE_ACROSS, /* what nodes of four spheres are tested with */
    SPH_STAGE_NODE,
    SPH_STAGE_PLANES, /* an inner node of a BIH, and a leaf of it */
    SPH_STAGE_LEAF,
    SPH_STAGE_FILTER, /* a child, in a sphere */
    SPH_STAGE_BOX,    /* a child, in a box */
    SPH_STAGE_SPHERE, /* exact tests */
    SPH_STAGE_TRIANGLE,
    SPH_STAGE_PLANE,
    SPH_STAGE_ROOT, /* of the discriminant */
    SPH_STAGE_KEY,  /* of a hit */
    SPH_STAGE_HIT,  /* the one that counts */
    SPH_STAGE_QUOTIENT,
    SPH_STAGE_POINT,
    SPH_STAGE_NORMAL,
    SPH_STAGE_MATERIAL,
    SPH_STAGE_PATH,
    SPH_STAGE_LEVEL,
    SPH_STAGE_TEXEL,
    SPH_STAGE_ALBEDO,
    SPH_STAGE_LIGHT,
    SPH_STAGE_HIGHLIGHT,
    SPH_STAGE_COLOUR,
    SPH_STAGE_PIXEL,
    SPH_STAGES
};

enum { SPH_STAGE_WORDS = 16, SPH_STAGE_TEXT = 1024 };

struct sph_stage_line {
    int ray, kind, stage;           /* of the pixel itself ray is INT_MAX */
    uint32_t visit;                 /* of the ray, from 1; 0 but for NODE to KEY */
    uint32_t number;                /* of child, primitive, texel or light */
    uint32_t clock;                 /* of the core, since the pixel came; 0 in the model */
    sph_u128 word[SPH_STAGE_WORDS]; /* the low bits of each count */
};

struct sph_stages {
    struct sph_stage_line *lines; /* freed by sph_stages_free() */
    int n, room;
    int full; /* memory was out: lines are missing */
    /* where the next line belongs */
    int rays;        /* that have started */
    int ray, kind;   /* the latest */
    int at, at_kind; /* the latest that is no shadow ray: whose surface it is */
    uint32_t visit, child, texel, light;
    uint32_t clock; /* what a line gets; the bench of the core counts it */
};

/* A ray begins, with the line RAY; what it hits, with the line HIT. */
void sph_stages_begin(struct sph_stages *s, const struct sph_ray *ray);
void sph_stages_end(struct sph_stages *s, const struct sph_ray *ray, const struct sph_hit *hit);

/* Adds a line of a stage with its n words, as the table has them. NODE, PLANES and LEAF count
 * the visits of a ray; children of a node, texels and lights of a surface are counted too, whatever
 * number they are given. A stage from QUOTIENT on belongs to the latest ray that is no shadow ray,
 * PIXEL to none. */
__attribute__((cold)) void sph_stages_note(struct sph_stages *s, int stage, uint32_t number,
                                           const sph_i128 *words, size_t n);
/* The same of numbers as arguments; s may be NULL, and then nothing happens. */
#define SPH_NOTE(s, stage, number, ...)                                                            \
    do {                                                                                           \
        struct sph_stages *to_ = (s);                                                              \
        if (to_)                                                                                   \
            sph_stages_note(to_, stage, number, (const sph_i128[]){__VA_ARGS__},                   \
                            sizeof(sph_i128[]){__VA_ARGS__} / sizeof(sph_i128));                   \
    } while (0)
#define SPH_THREE(v) (v)[0], (v)[1], (v)[2]

/* The pixel. */
void sph_stages_pixel(struct sph_stages *s, const struct sph_pixel *pixel);

/* Puts the lines into the one order: by ray, then stage by stage, then visit by visit. */
void sph_stages_sort(struct sph_stages *s);

/* Below 0, 0, above 0: a comes before, belongs to the same place as, comes behind b. */
int sph_stages_order(const struct sph_stage_line *a, const struct sph_stage_line *b);

/* The line as text, without an end of line: each number in hexadecimal digits of its width and as
 * what it stands for, lengths in scene units. */
void sph_stages_text(const struct sph_machine *m, const struct sph_stage_line *line,
                     char text[SPH_STAGE_TEXT]);

/* Operand k of a line, counted word by word; a vector is three of one name. 0; -1 behind the last.
 */
struct sph_operand {
    const char *name;
    int bits, sign; /* sign 1: two's complement */
    sph_u128 word;  /* the low bits of it count, the others are 0 */
    double value;   /* what it stands for; lengths in scene units */
};
int sph_stages_operand(const struct sph_machine *m, const struct sph_stage_line *line, int k,
                       struct sph_operand *to);

/* "set-up", "across", ... */
const char *sph_stages_name(int stage);

void sph_stages_free(struct sph_stages *s);

#endif
