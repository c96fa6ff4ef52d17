/* background.c - see background.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/background/background.h"

#include <stdlib.h>
#include <string.h>

#include "builder/background/cones.h"
#include "builder/emit.h"
#include "builder/background/rect.h"
#include "builder/background/spans.h"

/* An inner node's sphere in grid units. It holds every leaf below exactly (bound.h), so that a ray
 * that hits a leaf hits it too. */
static struct sph_ball node_ball(const struct sph_tree_node *node, const struct sph_profile *p) {
    struct sph_ball ball = node->ball;
    int32_t unit = 1 << (p->w - p->fw);
    for (int i = 0; i < 3; i++)
        ball.c[i] *= unit;
    ball.r *= unit;
    return ball;
}

int sph_background_balls(const struct sph_tree *tree, const struct sph_ball *balls,
                         const struct sph_profile *profile, int level, struct sph_ball *out) {
    const struct sph_tree_node *node[SPH_MAX_CONES] = {tree->nodes}, *below[SPH_MAX_CONES];
    struct sph_ball leaf[SPH_MAX_CONES];
    int nodes = 1, leaves = 0;
    for (; level > 0; level--) {
        int n = 0;
        for (int i = 0; i < nodes; i++) {
            for (int j = 0; j < node[i]->n_inner; j++)
                below[n++] = &tree->nodes[node[i]->child[j]];
            for (int j = 0; j < node[i]->n_leaf; j++)
                leaf[leaves++] = balls[node[i]->child[node[i]->n_inner + j]];
        }
        memcpy(node, below, sizeof node);
        nodes = n;
    }
    for (int i = 0; i < nodes; i++)
        out[i] = node_ball(node[i], profile);
    memcpy(out + nodes, leaf, (size_t)leaves * sizeof *leaf);
    return nodes + leaves;
}

/* Appends lines of zeros to memory and points BG_BASE at them; NULL if memory is out. */
static uint32_t *grow(struct sph_machine *m, uint32_t lines, struct sph_error *err) {
    uint64_t all = (uint64_t)m->lines + lines;
    uint32_t *mem = all < 1ull << SPH_NODE_BASE_BITS
                        ? realloc(m->mem, all * SPH_LINE_WORDS * sizeof *mem)
                        : NULL;
    if (!mem) {
        sph_fail(err, "out of memory or addresses for background separation");
        return NULL;
    }
    m->mem = mem;
    mem += (size_t)m->lines * SPH_LINE_WORDS;
    memset(mem, 0, (size_t)lines * SPH_LINE_WORDS * sizeof *mem);
    m->regs[SPH_REG_BG_BASE] = (int32_t)m->lines;
    m->regs[SPH_REG_MEM_LINES] = (int32_t)all;
    m->lines = (uint32_t)all;
    return mem;
}

static void emit_rect(const struct sph_rays *rays, struct sph_machine *m,
                      struct sph_build_report *report) {
    int32_t *r = m->regs;
    struct sph_rect rect = {0, 0, 0, 0};
    if (r[SPH_REG_N_PRIMS])
        rect = sph_rect_project(&report->root, r + SPH_REG_EYE_X, rays, r[SPH_REG_FRAME_W],
                                r[SPH_REG_FRAME_H], &report->bg_work);
    r[SPH_REG_RECT_X0] = rect.x0, r[SPH_REG_RECT_X1] = rect.x1;
    r[SPH_REG_RECT_Y0] = rect.y0, r[SPH_REG_RECT_Y1] = rect.y1;
}

static void note_spans(const struct sph_spans *spans, int asked, struct sph_build_report *report) {
    char *text = report->background;
    size_t size = sizeof report->background;
    report->bg_points = spans->points;
    if (spans->how == SPH_SPANS_BEHIND)
        sph_note(text, size, "spans: every sphere is behind the eye: no pixel is traced\n");
    else if (spans->how == SPH_SPANS_WHOLE)
        sph_note(text, size,
                 "spans: the root sphere is not wholly in front of the eye: every pixel is "
                 "traced\n");
    else
        sph_note(text, size, "spans: %d meridians and parallels asked for, %d needed%s\n", asked,
                 spans->points,
                 spans->how == SPH_SPANS_WIDENED ? ", and rows widened to the exact outline" : "");
}

static int emit_spans(const struct sph_rays *rays, const struct sph_build_options *o,
                      struct sph_machine *m, struct sph_build_report *report,
                      struct sph_error *err) {
    int32_t *r = m->regs;
    int points = o->bg_points ? o->bg_points : SPH_POINTS_DEFAULT;
    int height = r[SPH_REG_FRAME_H];
    struct sph_spans spans;
    uint32_t *table = grow(m, ((uint32_t)height + SPH_LINE_WORDS - 1) / SPH_LINE_WORDS, err);
    if (!table) return -1;
    if (!r[SPH_REG_N_PRIMS]) return 0;
    if (sph_spans_make(&spans, &report->root, r + SPH_REG_EYE_X, rays, r[SPH_REG_FRAME_W], height,
                       points, o->bg_border, err))
        return -1;
    for (int y = 0; y < height; y++) {
        sph_field_set(table + y, SPH_SPAN_X0_LSB, SPH_SPAN_X0_BITS, (uint32_t)spans.rows[y].x0);
        sph_field_set(table + y, SPH_SPAN_X1_LSB, SPH_SPAN_X1_BITS, (uint32_t)spans.rows[y].x1);
    }
    free(spans.rows);
    note_spans(&spans, points, report);
    sph_work_add(&report->bg_work, &spans.work);
    sph_work_add(&report->bg_check, &spans.check);
    return 0;
}

static int emit_cones(const struct sph_tree *tree, const struct sph_ball *balls,
                      const struct sph_rays *rays, int level, struct sph_machine *m,
                      struct sph_build_report *report, struct sph_error *err) {
    struct sph_ball ball[SPH_MAX_CONES];
    int n = m->regs[SPH_REG_N_PRIMS]
                ? sph_background_balls(tree, balls, sph_machine_profile(m), level, ball)
                : 0;
    uint32_t *table = grow(m, (uint32_t)n * SPH_CONE_LINES, err);
    if (!table) return -1;
    for (int i = 0; i < n; i++) {
        struct sph_cone cone =
            sph_cone_make(&ball[i], m->regs + SPH_REG_EYE_X, rays, &report->bg_work);
        sph_cone_put(table + i * SPH_CONE_LINES * SPH_LINE_WORDS, &cone);
    }
    m->regs[SPH_REG_BG_COUNT] = n;
    sph_note(report->background, sizeof report->background, "exact: %d sphere%s of level %d\n", n,
             n == 1 ? "" : "s", level);
    return 0;
}

int sph_emit_background(const struct sph_tree *tree, const struct sph_ball *balls,
                        const struct sph_rays *rays, const struct sph_build_options *o,
                        struct sph_machine *m, struct sph_build_report *report,
                        struct sph_error *err) {
    int32_t *r = m->regs;
    report->root = node_ball(tree->nodes, sph_machine_profile(m));
    r[SPH_REG_BG_MODE] = o->background;
    r[SPH_REG_RECT_X1] = r[SPH_REG_FRAME_W];
    r[SPH_REG_RECT_Y1] = r[SPH_REG_FRAME_H];
    if (o->background != SPH_BG_NONE && report->loose)
        sph_note(report->background, sizeof report->background,
                 "a plane may be seen anywhere: every pixel is traced\n");
    if (o->background == SPH_BG_RECT) emit_rect(rays, m, report);
    if (o->background == SPH_BG_SPANS) return emit_spans(rays, o, m, report, err);
    if (o->background == SPH_BG_EXACT)
        return emit_cones(tree, balls, rays, o->bg_levels, m, report, err);
    return 0;
}
