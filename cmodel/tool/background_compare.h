/* background_compare.h - every way of background separation on one view, measured
 * SPDX-License-Identifier: Apache-2.0
 *
 * The machine's ways are built and asked pixel by pixel as the model does; the paper's methods at
 * their word (literal) are drawn beside them. Truth: the pixels whose primary ray hits a sphere.
 */
#ifndef SPH_BACKGROUND_COMPARE_H
#define SPH_BACKGROUND_COMPARE_H

#include "builder/background/outline.h"
#include "tool/tool.h"

enum {
    WAY_NONE,
    WAY_RECT,
    WAY_RECT_LITERAL,
    WAY_SPANS,
    WAY_SPANS_LITERAL,
    WAY_SPANS_BARE,
    WAY_EXACT0,
    WAY_EXACT1,
    WAY_EXACT2,
    WAYS
};

struct way {
    uint8_t *traced;              /* per pixel, row by row */
    char background[512];         /* what build said of it */
    int no_answer;                /* a literal method that cannot project the sphere: all traced */
    uint64_t rays, found, wrong;  /* traced; background of the truth left out; hits left out */
    struct sph_work work, check;  /* set-up; proof that an outline covers */
    uint64_t add, compare, words; /* of the walk through the frame; words of memory read */
};

/* Unchecked outlines of n x n points. */
enum { SERIES = 5 };
struct series {
    int points;
    uint64_t missed[2], wrong[2]; /* pixels that see the root, a sphere; [1] with a border of 1 */
    uint64_t border;              /* pixels more that a border of 1 traces */
};

struct ways {
    int width, height;
    uint64_t background;  /* pixels that see no sphere */
    uint8_t *hit, *root;  /* per pixel: the ray hits a sphere; the root sphere */
    struct sph_ball ball; /* the root sphere, grid units */
    int32_t eye[3];
    struct sph_rays rays;
    int in_front; /* the root sphere can be projected; else there is no series */
    char name[128];
    struct way way[WAYS];
    struct series series[SERIES];
};

extern const char *const way_names[WAYS];

/* Measures all ways. -1 with a message; free with ways_free() either way. */
int ways_measure(const struct sph_scene *scene, const struct sph_build_options *options,
                 struct ways *ways, struct sph_error *err);

void ways_free(struct ways *ways);

/* Pictures of the steps, then of each way. */
enum { PICTURE_POINTS, PICTURE_ROWS, PICTURE_OUTLINE, PICTURE_SQUARE, PICTURE_WAYS };
enum { PICTURES = PICTURE_WAYS + WAYS };

/* The file of a picture in a folder; the caller frees. NULL if memory is out. */
char *ways_picture(const char *folder, int picture);

/* Writes the pictures into a folder that exists. 0, or -1. */
int ways_draw(const struct ways *ways, const char *folder, struct sph_error *err);

#endif
