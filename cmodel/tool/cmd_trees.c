/* cmd_trees.c - `sphaera trees`: what the rays of a scene do in each kind of tree
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <string.h>
#include <time.h>

#include "render/render.h"
#include "image/mips.h"
#include "reference/reference.h"
#include "tool/print.h"
#include "tool/report.h"

enum { BVH4, BIH, BOX4, BOXES, KD, KINDS }; /* from BOXES on in double precision */

static const char *const kind_names[KINDS] = {"bvh4", "bih", "box4", "boxes", "kd"};
static const int machine_trees[BOXES] = {SPH_TREE_REINSERTED, SPH_TREE_BIH, SPH_TREE_BOX4};

struct tree {
    struct sph_ref_work work;
    double draw_seconds; /* of processor */
};

/* A scene, and what is the same for all trees. */
struct job {
    const struct tool_report_arguments *a;
    const struct sph_scene *scene;
    struct sph_mip *mips;
    uint64_t picture;           /* of the machine */
    struct sph_reference truth; /* the picture in double precision */
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    const struct tool_report_arguments *a = state->input;
    if (key != ARGP_KEY_SUCCESS) return tool_report_key(key, arg, state, "no scene given");
    if (a->source.accel != TOOL_AUTO && a->source.accel != TOOL_BIH)
        argp_error(state, "all kinds of trees are built; --accel may be bih, for its options");
    return 0;
}

static double seconds(clock_t since) {
    return (double)(clock() - since) / CLOCKS_PER_SEC;
}

static int differ(const struct job *j, int kind, struct sph_error *err) {
    return sph_fail(err, "%s: the picture by tree %s is another one", j->a->input,
                    kind_names[kind]);
}

/* What is in memory before the primitives: nodes, and records of leaves. */
static struct sph_ref_work work_of(const struct tool_built *built, const struct sph_counters *c) {
    const struct sph_machine *m = &built->machine;
    const uint64_t line = SPH_LINE_WORDS * sizeof *m->mem, *count = c->count;
    return (struct sph_ref_work){
        .nodes = built->report.nodes,
        .node_bytes = sph_machine_bih(m) ? line / 2 : line,
        .bytes = (uint64_t)m->regs[SPH_REG_PRIM_BASE] * line,
        .build_seconds = built->report.tree_seconds,
        .rays = count[SPH_COUNT_RAYS_PRIMARY] + count[SPH_COUNT_RAYS_SHADOW] +
                count[SPH_COUNT_RAYS_REFLECTED] + count[SPH_COUNT_RAYS_REFRACTED],
        .steps = count[SPH_COUNT_NODE_VISITS],
        .tests = count[SPH_COUNT_LEAF_TESTS] + count[SPH_COUNT_FACET_TESTS]};
}

static int by_machine(struct job *j, int kind, struct tree *tree, struct sph_error *err) {
    struct tool_source source = j->a->source;
    struct tool_built built = {0};
    struct sph_frame frame = {0};
    struct sph_counters counters = {{0}};
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    source.build.tree = machine_trees[kind];
    if (source.build.axes == SPH_AXES_AUTO) source.build.axes = SPH_AXES_CAMERA; /* one for all */
    int rc = tool_build_scene(&source, j->scene, j->mips, &built, err);
    clock_t start = clock();
    if (!rc && sph_render(&built.machine, &how, &frame, &counters, err) < 0) rc = -1;
    tree->draw_seconds = seconds(start);
    if (!rc) {
        uint64_t picture = sph_frame_picture_hash(&frame);
        tree->work = work_of(&built, &counters);
        if (kind == BVH4) j->picture = picture;
        if (j->picture != picture) rc = differ(j, kind, err);
    }
    sph_frame_free(&frame);
    sph_machine_free(&built.machine);
    return rc;
}

static int same(const struct sph_reference *a, const struct sph_reference *b) {
    for (int i = 0; i < a->width * a->height; i++)
        if (a->pixels[i].id != b->pixels[i].id ||
            memcmp(a->pixels[i].colour, b->pixels[i].colour, sizeof a->pixels[i].colour) != 0)
            return 0;
    return 1;
}

static int by_doubles(struct job *j, int kind, struct tree *tree, struct sph_error *err) {
    struct sph_build_options b = j->a->source.build;
    struct sph_reference r = {0};
    if (tool_frame_size(&j->a->source, j->scene, &b, err)) return -1;
    struct sph_reference_options how = {.width = b.width,
                                        .height = b.height,
                                        .max_depth = b.max_depth,
                                        .shadow = b.shadow != SPH_OFF,
                                        .reflect = b.reflect != SPH_OFF,
                                        .refract = b.refract != SPH_OFF,
                                        .specular = b.specular != SPH_OFF,
                                        .mips = j->mips,
                                        .filter = b.tex_filter,
                                        .kd = kind == KD,
                                        .work = &tree->work};
    clock_t start = clock();
    if (sph_reference_render(j->scene, &how, &r, err)) return -1;
    tree->draw_seconds = seconds(start) - tree->work.build_seconds;
    if (kind == BOXES) {
        j->truth = r;
        return 0;
    }
    int rc = same(&r, &j->truth) ? 0 : differ(j, kind, err);
    sph_reference_free(&r);
    return rc;
}

static double mean(uint64_t sum, uint64_t n) {
    return n ? (double)sum / (double)n : 0;
}

static void print_trees(FILE *to, const struct tree *trees) {
    if (!to) return;
    fprintf(to, "%-6s %8s %10s %10s %9s %8s %8s %9s %9s %9s\n", "tree", "nodes", "a node", "bytes",
            "rays", "steps", "tests", "build s", "draw s", "image s");
    for (int i = 0; i < KINDS; i++) {
        const struct sph_ref_work *w = &trees[i].work;
        fprintf(to,
                "%-6s %8" PRIu64 " %10" PRIu64 " %10" PRIu64 " %9" PRIu64
                " %8.2f %8.2f %9.4f %9.4f %9.4f\n",
                kind_names[i], w->nodes, w->node_bytes, w->bytes, w->rays, mean(w->steps, w->rays),
                mean(w->tests, w->rays), w->build_seconds, trees[i].draw_seconds,
                w->build_seconds + trees[i].draw_seconds);
    }
}

static json_t *json_trees(const struct tree *trees) {
    json_t *all = json_array();
    for (int i = 0; i < KINDS; i++) {
        const struct sph_ref_work *w = &trees[i].work;
        json_t *tree = json_object();
        report_text(tree, "tree", kind_names[i]);
        report_count(tree, "nodes", w->nodes);
        report_count(tree, "node_bytes", w->node_bytes);
        report_count(tree, "bytes", w->bytes);
        report_count(tree, "rays", w->rays);
        report_count(tree, "steps", w->steps);
        report_count(tree, "tests", w->tests);
        report_number(tree, "build_seconds", w->build_seconds);
        report_number(tree, "draw_seconds", trees[i].draw_seconds);
        json_array_append_new(all, tree);
    }
    return all;
}

static int compare(struct job *j, struct sph_error *err) {
    struct tree trees[KINDS] = {0};
    if (j->a->source.build.texture != SPH_OFF && sph_mips_load(j->scene, &j->mips, err)) return -1;
    for (int i = 0; i < KINDS; i++)
        if (i < BOXES ? by_machine(j, i, &trees[i], err) : by_doubles(j, i, &trees[i], err))
            return -1;
    print_trees(print_stream(j->a->json), trees);
    json_t *report = report_new("trees");
    report_text(report, "input", j->a->input);
    report_add(report, "trees", json_trees(trees));
    return report_write(report, j->a->json, err);
}

int tool_trees(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        tool_report_options,
        parse,
        "SCENE",
        "Draws a scene by each kind of tree and counts what its rays do there.\v"
        "The machine's trees, in the model: nodes of four spheres (bvh4), bounding interval "
        "hierarchy (bih), nodes of four boxes (box4). In double precision, by the reference: a "
        "binary tree of boxes cut at the median (boxes), and a kd-tree by surface area (kd). Steps "
        "(nodes visited) and tests of primitives are means of a ray; seconds are of processor, "
        "with one thread. Pictures of the same arithmetic must be the same.",
        children,
        NULL,
        NULL};
    struct tool_report_arguments a = {.source = tool_source_default};
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_wants_scene(a.input, &err) || tool_scene_read(a.input, &a.source, &scene, &err))
        return tool_failed(&err);
    struct job j = {.a = &a, .scene = &scene};
    int rc = compare(&j, &err);
    sph_reference_free(&j.truth);
    sph_mips_free(j.mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
