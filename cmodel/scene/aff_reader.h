/* aff_reader.h - what the files that read AFF records share
 * SPDX-License-Identifier: Apache-2.0
 *
 * aff_take.c takes names and counts; aff_read.c files, aff_progress.c tells of them; aff_words.c
 * words and transforms; aff_mesh.c `m`, `tpa`; aff_keys.c `k`; aff_pose.c puts all in its place at
 * a time. Keys may stand behind what they move, so that primitives are kept as written up to the
 * end of the file: their `motion` holds the number of their transform.
 */
#ifndef SPH_AFF_READER_H
#define SPH_AFF_READER_H

#include "scene/nff_reader.h"
#include "scene/spline.h"

#define SPH_AFF_DEPTH 32       /* files that include one another */
#define SPH_AFF_INCLUDES 65536 /* in all */
#define SPH_AFF_COUNT 16777216 /* numbers of a list: vertices, keys, ... */
#define SPH_AFF_FLAT 1e-12     /* of the longest axis: a shorter one is scaled by 0 */

/* A transform within another one: still (`xs`), or of the keys of a name (`x`). */
struct sph_aff_node {
    uint32_t parent; /* index + 1, 0: the world */
    uint32_t line;
    struct sph_affine still, world; /* world: aff_pose.c */
    int visible, flat;              /* aff_pose.c */
    char name[SPH_LEX_TOKEN + 1];   /* empty: still */
};

enum { SPH_AFF_MOVE, SPH_AFF_TURN, SPH_AFF_SCALE, SPH_AFF_SEEN, SPH_AFF_TRACKS };

struct sph_aff_track {
    uint32_t n; /* 0: none */
    struct sph_key *key;
};

/* `k`: of SPH_AFF_SEEN, at.x is 0 or not. */
struct sph_aff_keys {
    char name[SPH_LEX_TOKEN + 1];
    struct sph_aff_track track[SPH_AFF_TRACKS];
};

/* `tpa`: n times, each with three points. */
struct sph_aff_patch {
    uint32_t facet, n;
    struct sph_aff_corners {
        double time;
        struct sph_vec v[3], n[3];
    } * at;
};

struct sph_aff_light {
    uint32_t node;
    char name[SPH_LEX_TOKEN + 1]; /* of `la` */
};

struct sph_aff {
    struct sph_reader r;
    char *open[SPH_AFF_DEPTH]; /* paths of the files that are being read */
    int depth;
    uint32_t includes, top_line; /* line of the first file that what is read now comes from */
    double detail;
    uint32_t node, n_nodes, n_keys, n_patches; /* node: the newest one, index + 1 */
    struct sph_aff_node *nodes;
    struct sph_aff_keys *keys;
    struct sph_aff_patch *patches;
    struct sph_aff_light lamp[SPH_MAX_LIGHTS];
    uint32_t a_line, am_line; /* of `a`, `am`; 0: none */
    double start, end, frames;
    const struct sph_progress *to; /* who is told how far it is; then all is not 0 */
    double all, done;              /* bytes of all files, of those that were read */
    struct sph_progress part[SPH_AFF_DEPTH + 1];
};

/* The path of a file that the one at `from` names; -1 if it is too long. */
int sph_aff_path(const char *from, const char *name, char *path, size_t size);

/* Looks how many bytes there are to read, if somebody is told (to may be NULL); tells from where on
 * the file that is open in the lexer is read. */
void sph_aff_tell(struct sph_aff *a, const struct sph_progress *to, const char *path);
void sph_aff_tell_file(struct sph_aff *a);

/* Room for element n of a list that grows by doubling; -1 with a message. */
int sph_aff_room(struct sph_aff *a, void *list, uint32_t n, size_t element, struct sph_error *err);

/* A whole number min .. max. */
int sph_aff_count(struct sph_aff *a, const char *record, const char *field, double min, double max,
                  uint32_t *count, struct sph_error *err);

/* Takes the word that comes next into name. */
int sph_aff_name(struct sph_aff *a, const char *record, const char *field,
                 char name[SPH_LEX_TOKEN + 1], struct sph_error *err);

/* Takes `{`. */
int sph_aff_brace(struct sph_aff *a, const char *record, struct sph_error *err);

/* A record that is no include, its first word next. */
int sph_aff_take_word(struct sph_aff *a, struct sph_error *err);

/* One record each, its first word taken. */
int sph_aff_take_m(struct sph_aff *a, struct sph_error *err);
int sph_aff_take_tpa(struct sph_aff *a, struct sph_error *err);
int sph_aff_take_k(struct sph_aff *a, struct sph_error *err);

/* Moves camera, lights and primitives to where they are at a time. -1 with a message if a sphere
 * would not stay one, or a triangle not. */
int sph_aff_pose(struct sph_aff *a, double time, struct sph_error *err);

#endif
