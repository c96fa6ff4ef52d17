/* aff_words.c - the words of AFF, and its transforms; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <string.h>

#include "scene/aff_reader.h"
#include "scene/nff_skip.h"

static int take_am(struct sph_aff *a, struct sph_error *err) {
    double *rgb = a->r.scene->ambient;
    if (a->am_line) return sph_fail(err, "%s:%u: second `am`", a->r.lex.path, a->r.lex.token_line);
    a->am_line = a->r.lex.token_line;
    if (sph_nff_numbers(&a->r, "am", sph_nff_colour, 3, rgb, err)) return -1;
    for (int i = 0; i < 3; i++)
        if (rgb[i] < 0) return sph_nff_fail(&a->r, err, "am", "a colour is negative");
    for (int i = 0; i < 3; i++)
        rgb[i] = fmin(rgb[i], 1);
    return 0;
}

/* a start end frames */
static int take_a(struct sph_aff *a, struct sph_error *err) {
    uint32_t frames = 0;
    if (a->a_line) return sph_fail(err, "%s:%u: second `a`", a->r.lex.path, a->r.lex.token_line);
    a->a_line = a->r.lex.token_line;
    if (sph_lex_number(&a->r.lex, "a", "start", &a->start, err) ||
        sph_lex_number(&a->r.lex, "a", "end", &a->end, err) ||
        sph_aff_count(a, "a", "frames", 1, SPH_AFF_COUNT, &frames, err))
        return -1;
    a->frames = frames;
    return a->end >= a->start ? 0 : sph_nff_fail(&a->r, err, "a", "the end is before the start");
}

static int take_d(struct sph_aff *a, struct sph_error *err) {
    return sph_lex_number(&a->r.lex, "d", "level of detail", &a->detail, err);
}

/* la NAME x y z [r g b] */
static int take_la(struct sph_aff *a, struct sph_error *err) {
    int n = a->r.scene->n_lights;
    char name[SPH_LEX_TOKEN + 1];
    if (sph_aff_name(a, "la", "name", name, err) || sph_nff_take_light(&a->r, err)) return -1;
    memcpy(a->lamp[n].name, name, sizeof name);
    return 0;
}

static int add_node(struct sph_aff *a, struct sph_aff_node *node, struct sph_error *err) {
    node->parent = a->node;
    node->line = a->r.lex.token_line;
    if (sph_aff_room(a, &a->nodes, a->n_nodes, sizeof *a->nodes, err)) return -1;
    a->nodes[a->n_nodes] = *node;
    a->node = ++a->n_nodes;
    return 0;
}

/* xs scale(3) axis(3) degrees translation(3) { ... } */
static int take_xs(struct sph_aff *a, struct sph_error *err) {
    struct sph_aff_node node = {.parent = 0};
    struct sph_vec scale, axis, move;
    double degrees;
    if (sph_nff_vec(&a->r, "xs", &scale, err) || sph_nff_vec(&a->r, "xs", &axis, err) ||
        sph_lex_number(&a->r.lex, "xs", "degrees", &degrees, err))
        return -1;
    if (degrees != 0 && !(sph_vec_length(axis) > 0))
        return sph_nff_fail(&a->r, err, "xs", "the axis is zero");
    if (sph_nff_vec(&a->r, "xs", &move, err) || sph_aff_brace(a, "xs", err)) return -1;
    node.still = sph_affine_of(scale, sph_turn_of(axis, degrees), move);
    return add_node(a, &node, err);
}

/* x NAME { ... } */
static int take_x(struct sph_aff *a, struct sph_error *err) {
    struct sph_aff_node node = {.parent = 0};
    if (sph_aff_name(a, "x", "name", node.name, err) || sph_aff_brace(a, "x", err)) return -1;
    return add_node(a, &node, err);
}

static const struct {
    const char *word;
    int (*take)(struct sph_aff *a, struct sph_error *err); /* NULL: as in NFF */
    enum sph_read kind;
} words[] = {{"d", take_d, SPH_READ_WORD},
             {"xs", take_xs, SPH_READ_WORD},
             {"x", take_x, SPH_READ_WORD},
             {"k", sph_aff_take_k, SPH_READ_WORD},
             {"m", sph_aff_take_m, SPH_READ_MESH},
             {"tpa", sph_aff_take_tpa, SPH_READ_TRIANGLE},
             {"a", take_a, SPH_READ_WORD},
             {"am", take_am, SPH_READ_COLOUR},
             {"la", take_la, SPH_READ_LIGHT},
             {.word = "v"},
             {.word = "b"},
             {.word = "l"},
             {.word = "f"},
             {.word = "fm"},
             {.word = "s"},
             {.word = "c"},
             {.word = "p"},
             {.word = "pp"},
             {.word = "tt"},
             {.word = "ttp"},
             {.word = "shading"}};
enum { N_WORDS = sizeof words / sizeof words[0] };

int sph_aff_take_word(struct sph_aff *a, struct sph_error *err) {
    int i = 0;
    while (i < N_WORDS && strcmp(a->r.lex.token, words[i].word) != 0)
        i++;
    if (i < N_WORDS && !words[i].take) return sph_nff_take_record(&a->r, err);
    uint32_t line = a->r.lex.token_line, facets = a->r.scene->n_facets;
    sph_lex_take(&a->r.lex);
    if (i == N_WORDS) return sph_nff_skip(&a->r, err);
    if (words[i].take(a, err)) return -1;
    if (words[i].kind != SPH_READ_WORD) sph_nff_mark(&a->r, facets, words[i].kind);
    return sph_nff_note(&a->r, words[i].kind, line, err);
}
