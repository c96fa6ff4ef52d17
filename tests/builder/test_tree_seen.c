/* test_tree_seen.c - trees that are rotated and collapsed by the rays of their frame
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include <math.h>

#include "builder/grid/bound.h"
#include "builder/tree/box.h"
#include "builder/tree/visibility_samples.h"
#include "builder/tree/split.h"
#include "common/parallel.h"
#include "core/frame.h"
#include "model_scene.h"
#include "scene/vector.h"
#include "trace/bih.h"
#include "trace/filter.h"
#include "trace/setup.h"
#include "validate/validate.h"

enum { W = 64, H = 36 };

enum { ANY = -1 }; /* no background separation, and the axes that build chooses */

static struct sph_machine build(const struct sph_scene *scene, int tree, int background,
                                struct sph_kept_tree *kept) {
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {{0}};
    o.tree = tree, o.width = W, o.height = H, o.texture = SPH_OFF;
    o.kept = kept;
    if (background != ANY) o.axes = SPH_AXES_CAMERA, o.background = background;
    if (sph_build(scene, &o, &m, &report, &err)) fail_msg("%s", err.text);
    return m;
}

/* Visits of a frame; *hash: of its picture. */
static double visits(const struct sph_machine *m, int how, uint64_t *hash) {
    struct sph_counters c;
    int errors;
    struct sph_frame f = model_render(m, how, 0, &c, &errors);
    assert_int_equal(errors, 0);
    *hash = sph_frame_picture_hash(&f);
    sph_frame_free(&f);
    return (double)c.count[SPH_COUNT_NODE_VISITS];
}

static const struct {
    const char *path;
    int tree;
    double most; /* of the visits in the tree of another view */
} cases[] = {{"scenes/paper100.nff", SPH_TREE_REINSERTED, 0.96},
             {"scenes/facets/triangles.nff", SPH_TREE_BOX4, 1},
             {"scenes/facets/room.nff", SPH_TREE_BOX4, 0.96},
             {"scenes/texture/kitchen.nff", SPH_TREE_BOX4, 0.98},
             {"scenes/texture/museum.nff", SPH_TREE_BOX4, 0.94}};
enum { CASES = sizeof cases / sizeof *cases };

/* A machine built with so many threads. */
static struct sph_machine build_by(int threads, const struct sph_scene *scene, int tree) {
    int before = sph_parallel_most(threads);
    struct sph_machine m = build(scene, tree, ANY, NULL);
    sph_parallel_most(before);
    return m;
}

/* The same picture takes fewer visits than in the tree that the view behind asked for, and the tree
 * is the same whatever the number of threads. */
static void gains(void **state) {
    (void)state;
    for (int i = 0; i < (SANITIZED ? 2 : CASES); i++) {
        struct sph_scene scene = read_scene(cases[i].path), back = scene;
        struct sph_kept_tree kept = {.how = SPH_REFIT_ON};
        struct sph_vec *at = &back.camera.at, from = back.camera.from;
        uint64_t hash[2];
        *at = (struct sph_vec){2 * from.x - at->x, 2 * from.y - at->y, 2 * from.z - at->z};
        struct sph_machine m = build(&back, cases[i].tree, ANY, &kept);
        sph_machine_free(&m);
        m = build(&scene, cases[i].tree, ANY, &kept);
        assert_true(kept.refitted);
        double other = visits(&m, SPH_TRAVERSE_TREE, &hash[0]);
        sph_machine_free(&m);
        m = build_by(1, &scene, cases[i].tree);
        double own = visits(&m, SPH_TRAVERSE_TREE, &hash[1]);
        printf("# %-28s visits: %.0f, in the tree of the view behind %.0f: %.3f\n", cases[i].path,
               own, other, own / other);
        assert_true(hash[0] == hash[1]);
        assert_true(own < cases[i].most * other);
        struct sph_machine same = build_by(5, &scene, cases[i].tree);
        assert_int_equal(same.lines, m.lines);
        assert_memory_equal(same.regs, m.regs, sizeof m.regs);
        assert_memory_equal(same.mem, m.mem, m.lines * SPH_LINE_WORDS * sizeof *m.mem);
        sph_machine_free(&same);
        sph_machine_free(&m);
        sph_kept_free(&kept);
        sph_scene_free(&scene);
    }
}

/* Gives every triangle normals that are not its own. */
static void bend(struct sph_scene *s) {
    for (uint32_t i = 0; i < s->n_facets; i++) {
        struct sph_facet *f = &s->facets[i];
        if (f->kind != SPH_TRIANGLE) continue;
        struct sph_vec own =
            sph_vec_cross(sph_vec_sub(f->v[1], f->v[0]), sph_vec_sub(f->v[2], f->v[0]));
        for (int k = 0; k < 3; k++)
            f->n[k] = own, (&f->n[k].x)[k] += 0.2 * sph_vec_length(own);
        f->smooth = 1;
    }
}

/* Whatever stands behind the tree is found where it went: normals, spans, facets. */
static void whole(void **state) {
    (void)state;
    static const struct {
        const char *path;
        int tree, background;
    } all[] = {{"scenes/facets/room.nff", SPH_TREE_BOX4, SPH_BG_NONE},
               {"scenes/facets/triangles.nff", SPH_TREE_REINSERTED, SPH_BG_SPANS},
               {"tests/scenes/facets/mixed.nff", SPH_TREE_BOX4, SPH_BG_EXACT},
               {"scenes/paper100.nff", SPH_TREE_REINSERTED, SPH_BG_SPANS}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct sph_scene scene = read_scene(all[i].path);
        bend(&scene);
        struct sph_machine m = build(&scene, all[i].tree, all[i].background, NULL);
        struct sph_error err = {{0}};
        uint64_t hash[2];
        if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
        visits(&m, SPH_TRAVERSE_TREE, &hash[0]);
        sph_machine_free(&m);
        m = build(&scene, SPH_TREE_BALANCED, SPH_BG_NONE, NULL);
        visits(&m, SPH_TRAVERSE_BRUTE, &hash[1]);
        assert_true(hash[0] == hash[1]);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
}

enum { MOST = 20000 };

/* Rays of a sample, with one thread. */
struct rays {
    int n;
    struct sph_logged list[MOST];
};

static void keep(void *user, const struct sph_logged *ray) {
    struct rays *rays = user;
    assert_true(rays->n < MOST);
    rays->list[rays->n++] = *ray;
}

/* Whether a ray meets what bounds the spheres of a pair. */
static int meets(const struct sph_ball *balls, const struct sph_aabb *boxes,
                 const struct sph_profile *p, const struct sph_split *split, uint32_t pair,
                 const struct sph_logged *l) {
    const uint32_t *order = split->order + split->pairs[pair].first;
    uint32_t n = split->pairs[pair].count;
    uint64_t key = l->ray.kind == SPH_SHADOW ? 0 : l->hit.key;
    int32_t near;
    if (!boxes) {
        struct sph_ball b = sph_filter_enclose(balls, order, n, p);
        struct sph_child c = {{b.c[0], b.c[1], b.c[2]}, b.r + SPH_FILTER_MARGIN};
        int32_t most = key ? sph_ray_depth(p, &l->ray, key) : l->ray.depth_max;
        return sph_filter(&l->ray, &c, most, &near);
    }
    struct sph_box box = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    struct sph_visibility_sample s = {.ray = l->ray};
    sph_bih_setup(p, &l->ray, &s.planes);
    for (uint32_t i = 0; i < n; i++)
        for (int j = 0; j < 3; j++) {
            if (boxes[order[i]].lo[j] < box.lo[j]) box.lo[j] = boxes[order[i]].lo[j];
            if (boxes[order[i]].hi[j] > box.hi[j]) box.hi[j] = boxes[order[i]].hi[j];
        }
    s.depth_max = sph_box_depth(key ? sph_bih_time(&s.planes, key) : s.planes.limit);
    return sph_visibility_sample_meets_box(&s, &box);
}

/* What a pair is met like, by its costs. */
static double area(const struct sph_pair *p) {
    return (double)p->cost[1] - (double)p->cost[0];
}

/* Rays that meet a pair and all above it, weighted. */
static void count(const struct sph_ball *balls, const struct sph_aabb *boxes,
                  const struct sph_profile *p, const struct sph_split *split,
                  const struct rays *rays, uint64_t *met) {
    uint32_t *above = calloc(split->n_pairs, sizeof *above);
    for (uint32_t i = 0; i < split->n_pairs; i++)
        for (int j = 0; j < 2; j++)
            if (!(split->pairs[i].child[j] & SPH_PAIR_LEAF)) above[split->pairs[i].child[j]] = i;
    for (uint32_t i = 0; i < split->n_pairs; i++)
        for (int j = 0; j < rays->n; j++) {
            const struct sph_logged *l = &rays->list[j];
            uint32_t at = i;
            while (meets(balls, boxes, p, split, at, l) && at)
                at = above[at];
            if (!at && meets(balls, boxes, p, split, 0, l))
                met[i] += l->ray.kind == SPH_SHADOW && l->hit.key ? 1 : 3;
        }
    free(above);
}

/* A hundred spheres as balls and boxes, and rays of their frame. */
struct hundred {
    uint32_t n;
    const struct sph_profile *profile;
    struct sph_ball *balls;
    struct sph_aabb *boxes;
    struct sph_machine machine;
};

static struct hundred hundred(void) {
    struct sph_scene scene = read_scene(SANITIZED ? "scenes/paper5.nff" : "scenes/paper100.nff");
    struct hundred h = {.n = scene.n_spheres, .profile = &sph_profiles[SPH_STANDARD]};
    struct sph_facets none = {0};
    struct sph_grid grid;
    struct sph_error err = {{0}};
    double smallest;
    h.balls = malloc(h.n * sizeof *h.balls);
    h.boxes = malloc(h.n * sizeof *h.boxes);
    assert_int_equal(sph_grid_fit(&scene, h.profile->w, SPH_AXES_CAMERA, &grid, &err), 0);
    uint8_t lost[101] = {0};
    assert_in_range(h.n, 1, sizeof lost);
    assert_int_equal(sph_grid_spheres(&grid, &scene, h.profile, h.balls, lost, &smallest, &err), 0);
    struct sph_plants plants = {
        .balls = h.balls, .n_spheres = h.n, .facets = &none, .profile = h.profile};
    for (uint32_t i = 0; i < h.n; i++)
        sph_box_of(&plants, i, &h.boxes[i]);
    h.machine = build(&scene, SPH_TREE_REINSERTED, SPH_BG_NONE, NULL);
    sph_scene_free(&scene);
    return h;
}

static void hundred_free(struct hundred *h) {
    sph_machine_free(&h->machine);
    free(h->balls);
    free(h->boxes);
}

static struct rays rays_of(const struct sph_machine *m) {
    static struct rays rays;
    struct sph_error err = {{0}};
    int threads = sph_parallel_most(1);
    rays.n = 0;
    assert_int_equal(sph_sample(m, keep, &rays, &err), 0);
    assert_true(rays.n > W * H / 16);
    sph_parallel_most(threads);
    return rays;
}

/* Counts are those that a look at every pair gives, whatever the number of threads. */
static void counts(void **state) {
    (void)state;
    struct hundred h = hundred();
    struct sph_error err = {{0}};
    static struct rays rays;
    rays = rays_of(&h.machine);
    for (int way = 0; way < 2; way++) {
        const struct sph_aabb *b = way ? h.boxes : NULL;
        struct sph_split split, area_of;
        struct sph_visibility_samples samples;
        uint64_t *met = calloc(h.n, sizeof *met);
        assert_int_equal(sph_split(h.balls, b, h.n, 64, NULL, &split, &err), 0);
        area_of = split;
        area_of.pairs = malloc(split.n_pairs * sizeof *split.pairs);
        memcpy(area_of.pairs, split.pairs, split.n_pairs * sizeof *split.pairs);
        sph_split_fill(h.balls, b, h.profile, &area_of);
        count(h.balls, b, h.profile, &split, &rays, met);
        sph_parallel_most(3);
        assert_int_equal(sph_visibility_samples(&h.machine, way, &samples, &err), 0);
        assert_int_equal(samples.n, rays.n);
        assert_int_equal(sph_split_seen(h.balls, b, h.profile, &samples, &split, &err), 0);
        sph_parallel_most(0);
        for (uint32_t i = 0; i < split.n_pairs; i++) {
            double unseen = area(&area_of.pairs[i]) / area(&area_of.pairs[0]) / 16;
            double seen = (double)met[i] / (double)met[0];
            double got = area(&split.pairs[i]) / area(&split.pairs[0]) * (1 + 1 / 16.);
            if (!(fabs(got - seen - unseen) < 1e-3))
                fail_msg("pair %u of %u: %.5f, met by %.5f, area/16 %.5f", i, split.n_pairs, got,
                         seen, unseen);
        }
        printf("# %s: %d rays, %u pairs\n", way ? "boxes" : "balls", rays.n, split.n_pairs);
        sph_visibility_samples_free(&samples);
        free(area_of.pairs);
        free(met);
        sph_split_free(&split);
    }
    hundred_free(&h);
}

/* Rays that meet pairs, weighted, all pairs together. */
static uint64_t all_met(const struct hundred *h, const struct sph_split *split,
                        const struct rays *rays) {
    uint64_t *met = calloc(h->n, sizeof *met), sum = 0;
    count(h->balls, h->boxes, h->profile, split, rays, met);
    for (uint32_t i = 0; i < split->n_pairs; i++)
        sum += met[i];
    free(met);
    return sum;
}

/* Spheres below a child of a pair, each of which is met once; pairs stand behind their parents, and
 * their spheres side by side in the order. */
static uint32_t below(const struct sph_split *split, uint32_t child, uint32_t first,
                      uint8_t *found) {
    if (child & SPH_PAIR_LEAF) {
        assert_int_equal(split->order[first], child & ~SPH_PAIR_LEAF);
        assert_int_equal(found[child & ~SPH_PAIR_LEAF]++, 0);
        return 1;
    }
    const struct sph_pair *p = &split->pairs[child];
    assert_int_equal(p->first, first);
    uint32_t n = 0;
    for (int i = 0; i < 2; i++) {
        assert_true(p->child[i] & SPH_PAIR_LEAF || p->child[i] > child);
        n += below(split, p->child[i], first + n, found);
    }
    assert_int_equal(p->count, n);
    return n;
}

/* A rotated tree has all that it had and is met by fewer rays, whatever the number of threads; it
 * stays as it is where it would need more levels than there are. */
static void rotates(void **state) {
    (void)state;
    struct hundred h = hundred();
    struct sph_error err = {{0}};
    struct sph_visibility_samples samples;
    static struct rays rays;
    struct sph_split splits[3];
    rays = rays_of(&h.machine);
    assert_int_equal(sph_visibility_samples(&h.machine, 1, &samples, &err), 0);
    for (int i = 0; i < 3; i++) {
        struct sph_split *s = &splits[i];
        assert_int_equal(sph_split(h.balls, h.boxes, h.n, 64, NULL, s, &err), 0);
        sph_split_fill(h.balls, h.boxes, h.profile, s);
        sph_parallel_most(i ? 5 : 1);
        int most = i < 2 ? s->pairs[0].levels[1] + 2 : s->pairs[0].levels[1] - 1;
        uint64_t before = all_met(&h, s, &rays);
        assert_int_equal(sph_split_rotate(h.balls, h.boxes, &samples, SPH_UNSEEN, most, s, &err),
                         0);
        uint64_t after = all_met(&h, s, &rays);
        uint8_t *found = calloc(h.n, 1);
        assert_int_equal(below(s, 0, 0, found), h.n);
        free(found);
        if (i == 2)
            assert_int_equal(after, before);
        else
            assert_true(s->pairs[0].levels[1] <= most && (SANITIZED || 100 * after < 97 * before));
        printf("# rays that meet pairs: %llu, rotated %llu\n", (unsigned long long)before,
               (unsigned long long)after);
    }
    sph_parallel_most(0);
    for (uint32_t i = 0; i < splits[0].n_pairs; i++)
        assert_memory_equal(splits[0].pairs[i].child, splits[1].pairs[i].child,
                            sizeof splits[0].pairs[i].child);
    for (int i = 0; i < 3; i++)
        sph_split_free(&splits[i]);
    sph_visibility_samples_free(&samples);
    hundred_free(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(counts), cmocka_unit_test(rotates),
                                       cmocka_unit_test(gains), cmocka_unit_test(whole)};
    return cmocka_run_group_tests_name("tree seen", tests, NULL, NULL);
}
