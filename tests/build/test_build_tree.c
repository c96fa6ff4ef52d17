/* test_build_tree.c - the tree that hardware builds: what its words promise
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_build_tree [seed]
 */
#include "drawn_spheres.h"
#include "model_scene.h"

enum { MOST = 700 };
static uint64_t state;
static struct sph_bt_leaf leaves[MOST];
static uint32_t memory[(4 * MOST + 8) * SPH_LINE_WORDS], before[sizeof memory / 4];

static uint64_t next(void *of) {
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    (void)of;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static void draw(enum drawn_kind kind, uint32_t n, const struct sph_profile *p,
                 struct sph_bt_job *job) {
    drawn_spheres(kind, leaves, n, p, next, NULL);
    *job = (struct sph_bt_job){n, 3, n + 5, (uint32_t)sph_bt_lines(n), SPH_BUILD_CURVE, 0, NULL};
    for (size_t i = 0; i < sizeof memory / 4; i++)
        memory[i] = (uint32_t)next(NULL);
    for (uint32_t id = 0; id < n; id++)
        drawn_record(memory + (size_t)(job->prim_base + id) * SPH_LINE_WORDS, id, &leaves[id],
                     next(NULL));
    memcpy(before, memory, sizeof memory);
}

struct above {
    int n;
    int64_t ctr[SPH_STACK_DEPTH + 1][3], rad[SPH_STACK_DEPTH + 1]; /* grid units */
};

static struct {
    const struct sph_profile *p;
    const struct sph_bt_job *job;
    uint32_t end; /* line behind all that was written */
    uint8_t used[4 * MOST], node[4 * MOST], found[MOST];
} walk;

/* Every sphere below a line lies in all spheres above it, in exact integers; deepest level. */
static int check_below(uint32_t line, struct above *up) {
    const uint32_t *node = memory + (size_t)line * SPH_LINE_WORDS;
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n = inner + sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    int k = walk.p->w - walk.p->fw, deepest = up->n + 1;
    assert_true(up->n < SPH_STACK_DEPTH && n <= 4 && base > line);
    for (uint32_t i = 0; i < 4; i++) {
        int at = (int)i * SPH_CHILD_STRIDE;
        int64_t rad = sph_field(node, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
        if (i >= n) { /* an unused slot is zero */
            for (int bit = 0; bit < SPH_CHILD_STRIDE; bit += 28)
                assert_int_equal(sph_field(node, at + bit, 28), 0);
            continue;
        }
        up->rad[up->n] = (rad - SPH_FILTER_MARGIN) * (1ll << k);
        for (int j = 0; j < 3; j++)
            up->ctr[up->n][j] = sph_field_signed(node, at + 14 * j, 14) * (1ll << k);
        up->n++;
        uint32_t to = i < inner ? base + i : base + inner + (i - inner) / 2;
        assert_true(to < walk.end && (i < inner || (i - inner) % 2 || !walk.used[to]));
        walk.used[to] = 1;
        walk.node[to] = i < inner;
        if (i < inner) {
            int level = check_below(to, up);
            if (level > deepest) deepest = level;
        } else {
            const uint32_t *leaf = memory + (size_t)to * SPH_LINE_WORDS + (i - inner) % 2 * 4;
            uint32_t id = sph_field(leaf, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
            assert_true(id < walk.job->n && !walk.found[id]++);
            assert_memory_equal(leaf, before + (size_t)(walk.job->prim_base + id) * SPH_LINE_WORDS,
                                16);
            for (int a = 0; a < up->n; a++) {
                int64_t room = up->rad[a] - leaves[id].rad, sum = 0;
                for (int j = 0; j < 3; j++) {
                    int64_t d = up->ctr[a][j] - leaves[id].ctr[j];
                    sum += d * d;
                }
                int whole = !up->ctr[a][0] && !up->ctr[a][1] && !up->ctr[a][2] &&
                            up->rad[a] >= 1.732 * (double)(1ll << (walk.p->w - 1));
                assert_true(whole || (room >= 0 && room * room >= sum));
            }
        }
        up->n--;
    }
    return deepest;
}

static const uint32_t sizes[] = {
    0,    1, 2, 3, 4, 5, 8, 17, 64, 65, /* around full nodes */
    MOST,                               /* deep enough for what is cut in halves */
};

static void test_words(void **unused) {
    (void)unused;
    int deepest = 0;
    for (int profile = 0; profile < SPH_PROFILES; profile++)
        for (int kind = 0; kind < DRAWN_KINDS; kind++)
            for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
                struct sph_bt_job job;
                struct above up = {0};
                struct sph_error err;
                uint32_t written;
                draw((enum drawn_kind)kind, sizes[i], &sph_profiles[profile], &job);
                assert_int_equal(
                    sph_bt_words(memory, &job, MOST, &sph_profiles[profile], &written, &err), 0);
                assert_true(written && written <= job.lines);
                memset(&walk, 0, sizeof walk);
                walk.p = &sph_profiles[profile], walk.job = &job, walk.end = job.root + written;
                int level = check_below(job.root, &up);
                if (level > deepest) deepest = level;
                for (uint32_t id = 0; id < job.n; id++)
                    assert_int_equal(walk.found[id], 1);
                for (uint32_t line = job.root + 1; line < walk.end; line++)
                    assert_int_equal(walk.used[line], 1);
                for (size_t w = 0; w < sizeof memory / 4; w++)
                    if (w / SPH_LINE_WORDS < job.root || w / SPH_LINE_WORDS >= walk.end)
                        assert_int_equal(memory[w], before[w]);
            }
    assert_true(deepest > 12); /* or nothing was cut in halves */
}

/* Places in the order of keys made bit by bit, equal ones by number. */
static void test_order(void **unused) {
    (void)unused;
    static uint32_t order[MOST];
    static uint64_t spare[2 * MOST];
    for (int kind = 0; kind < DRAWN_KINDS; kind++) {
        const struct sph_profile *p = &sph_profiles[kind % SPH_PROFILES];
        uint8_t seen[MOST] = {0};
        int32_t lo[3] = {INT32_MAX, INT32_MAX, INT32_MAX}, most = 0;
        drawn_spheres((enum drawn_kind)kind, leaves, MOST, p, next, NULL);
        sph_bt_order(leaves, MOST, SPH_BUILD_CURVE, p, order, spare);
        for (int i = 0; i < MOST; i++)
            for (int k = 0; k < 3; k++)
                if (leaves[i].ctr[k] < lo[k]) lo[k] = leaves[i].ctr[k];
        for (int i = 0; i < MOST; i++)
            for (int k = 0; k < 3; k++)
                if (leaves[i].ctr[k] - lo[k] > most) most = leaves[i].ctr[k] - lo[k];
        int shift = 0;
        while (most >> shift >> SPH_BUILD_AXIS)
            shift++;
        for (int i = 0; i < MOST; i++) {
            assert_true(order[i] < MOST && !seen[order[i]]++);
            if (!i) continue;
            const struct sph_bt_leaf *a = &leaves[order[i - 1]], *b = &leaves[order[i]];
            int differs = -1; /* the axis of the highest bit that differs, x before y before z */
            uint32_t highest = 0;
            for (int k = 0; k < 3; k++) {
                uint32_t d =
                    (uint32_t)(a->ctr[k] - lo[k]) >> shift ^ (uint32_t)(b->ctr[k] - lo[k]) >> shift;
                if (d > highest && (d ^ highest) > highest) highest = d, differs = k;
            }
            if (differs < 0)
                assert_true(order[i - 1] < order[i]);
            else
                assert_true(a->ctr[differs] < b->ctr[differs]);
        }
    }
}

enum { ROW = 60 };

/* The longest edge of the box around spheres that a or b holds, in units of joining. */
static uint32_t longest_edge(const uint8_t *a, const uint8_t *b, const struct sph_profile *p) {
    uint32_t most = 0;
    int cut = p->w + 2 > SPH_BUILD_SIDE ? p->w + 2 - SPH_BUILD_SIDE : 0;
    for (int k = 0; k < 3; k++) {
        int32_t lo = INT32_MAX, hi = INT32_MIN;
        for (int i = 0; i < ROW; i++) {
            if (!a[i] && !b[i]) continue;
            if (leaves[i].ctr[k] - leaves[i].rad < lo) lo = leaves[i].ctr[k] - leaves[i].rad;
            if (leaves[i].ctr[k] + leaves[i].rad > hi) hi = leaves[i].ctr[k] + leaves[i].rad;
        }
        uint32_t edge = (uint32_t)((hi >> cut) - (lo >> cut));
        if (edge > most) most = edge;
    }
    return most;
}

/* In a pass those pairs are joined that are less than every other one that has a cluster of them;
 * the tree's order has the spheres of every cluster side by side. */
static void test_join(void **unused) {
    (void)unused;
    int evens = 0;
    for (int run = 0; run < 10 * DRAWN_KINDS; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        struct sph_bt_pair pairs[ROW] = {{0}};
        static uint8_t has[ROW][ROW]; /* which spheres are in a cluster of the row */
        static uint64_t key[ROW][ROW];
        uint32_t order[ROW], number[ROW], n = ROW, root, place[ROW];
        uint64_t spare[2 * ROW];
        int even = 0;
        drawn_spheres((enum drawn_kind)(run % DRAWN_KINDS), leaves, ROW, p, next, NULL);
        sph_bt_order(leaves, ROW, SPH_BUILD_CURVE, p, order, spare);
        memset(has, 0, sizeof has);
        for (uint32_t i = 0; i < ROW; i++)
            has[i][number[i] = order[i]] = 1;
        assert_int_equal(sph_bt_join(leaves, ROW, p, order, pairs, &root), 0);
        for (uint32_t i = 0; i < ROW; i++)
            place[order[i]] = i;
        while (n > 1) {
            uint32_t left = 0, gone[ROW] = {0};
            for (uint32_t i = 0; i < n; i++)
                for (uint32_t j = i + 1; j < n; j++) {
                    uint32_t k = j - i, unit = k & -k;
                    key[i][j] = key[j][i] =
                        k > SPH_BUILD_WINDOW
                            ? UINT64_MAX
                            : (uint64_t)(even ? 0 : longest_edge(has[i], has[j], p)) << 16 |
                                  k << 8 | !!(i & unit);
                }
            for (uint32_t i = 0; i < n; i++) {
                uint32_t j = n;
                for (uint32_t to = i + 1; to < n && j == n; to++) {
                    int least = key[i][to] != UINT64_MAX;
                    for (uint32_t other = 0; other < n; other++)
                        least &= (other == i || other == to ||
                                  (key[i][other] > key[i][to] && key[to][other] > key[i][to]));
                    if (least) j = to;
                }
                if (gone[i]) continue;
                if (j < n) {
                    uint32_t tail = ROW, first = ROW, count[2] = {0};
                    for (uint32_t id = 0; id < ROW; id++) {
                        if (has[i][id] && (tail == ROW || place[id] > place[tail])) tail = id;
                        if ((has[i][id] || has[j][id]) && place[id] < first) first = place[id];
                        count[0] += has[i][id], count[1] += has[j][id];
                    }
                    for (uint32_t at = 0; at < count[0] + count[1]; at++)
                        assert_true(has[at < count[0] ? i : j][order[first + at]]);
                    assert_int_equal(pairs[tail].cut, first + count[0] - 1);
                    assert_int_equal(pairs[tail].size, longest_edge(has[i], has[j], p));
                    assert_int_equal(pairs[tail].left, number[i]);
                    assert_int_equal(pairs[tail].right, number[j]);
                    for (uint32_t id = 0; id < ROW; id++)
                        has[i][id] |= has[j][id];
                    number[i] = tail;
                    gone[j] = 1;
                }
                number[left] = number[i];
                memmove(has[left++], has[i], ROW);
            }
            assert_true(left < n);
            even = !even && left > n - n / 8;
            evens += even;
            n = left;
        }
        assert_int_equal(root, number[0]);
    }
    assert_true(evens > 0); /* or no pass was forced */
}

static void test_errors(void **unused) {
    (void)unused;
    static const struct {
        int lsb, bits;  /* a field of a record, */
        uint32_t value; /* that becomes this; bits 0: none does */
        int fewer;      /* lines */
        uint32_t most;
        int reasons;
    } cases[] = {
        {0, 0, 0, 0, 9, 0},                                                /* as it should be */
        {0, 0, 0, 0, 8, SPH_BT_MANY},                                      /* one too many */
        {0, 0, 0, 1, 9, SPH_BT_ROOM},                                      /* a line too few */
        {0, 0, 0, 1, 8, SPH_BT_MANY | SPH_BT_ROOM},                        /* both */
        {SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, 0, 0, 9, SPH_BT_RECORD},     /* no radius */
        {SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, 65536, 0, 9, SPH_BT_RECORD}, /* above W bits */
        {SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, 65535, 0, 9, 0},             /* the largest */
        {SPH_LEAF_CTR_Y_LSB, 24, 32768, 0, 9, SPH_BT_RECORD},              /* beyond the grid */
        {SPH_LEAF_CTR_Y_LSB, 24, 32767, 0, 9, 0},                          /* its last point */
        {SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, 6, 0, 9, SPH_BT_RECORD},       /* another's number */
        {SPH_PRIM_KIND_LSB, SPH_PRIM_KIND_BITS, 1, 0, 9, SPH_BT_RECORD},   /* a triangle */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_bt_job job;
        struct sph_error err;
        uint32_t written;
        draw(DRAWN_SMALL, 9, &sph_profiles[SPH_STANDARD], &job);
        if (cases[i].bits)
            sph_field_set(memory + (size_t)(job.prim_base + 5) * SPH_LINE_WORDS, cases[i].lsb,
                          cases[i].bits, cases[i].value);
        job.lines -= (uint32_t)cases[i].fewer;
        memcpy(before, memory, sizeof memory);
        assert_int_equal(
            sph_bt_words(memory, &job, cases[i].most, &sph_profiles[SPH_STANDARD], &written, &err),
            cases[i].reasons);
        assert_int_equal(!written, !!cases[i].reasons);
        if (cases[i].reasons) assert_memory_equal(memory, before, sizeof memory);
    }
}

/* A machine built with the paper's tree: its nodes and leaf records are those of rt_build. */
static void test_paper(void **unused) {
    (void)unused;
    static const struct {
        const char *scene;
        int profile;
    } cases[] = {
        {"empty", SPH_STANDARD},      /* a root without children */
        {"one_sphere", SPH_STANDARD}, /* one level */
        {"paper5", SPH_DRAFT},        /* a node of one child */
        {"sphereflake2", SPH_FINE},   /* many of one z */
        {"paper100", SPH_STANDARD},   /* four levels */
        {"paper100", SPH_DRAFT},      /* filter units are grid units */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct sph_scene scene = model_scene(cases[i].scene);
        struct sph_build_options o = SPH_BUILD_DEFAULT;
        struct sph_build_report report;
        struct sph_machine m;
        struct sph_error err = {{0}};
        uint32_t written;
        o.tree = SPH_TREE_PAPER, o.profile = cases[i].profile;
        if (sph_build(&scene, &o, &m, &report, &err)) fail_msg("%s", err.text);
        uint32_t lines = (uint32_t)m.regs[SPH_REG_PRIM_BASE], n = (uint32_t)m.regs[SPH_REG_N_PRIMS];
        size_t words = (size_t)lines * SPH_LINE_WORDS;
        uint32_t *built = malloc(words * sizeof *built);
        struct sph_bt_job job = {n, lines, 0, UINT32_MAX, SPH_BUILD_PAPER, 0, NULL};
        assert_non_null(built);
        memcpy(built, m.mem, words * sizeof *built);
        memset(m.mem, 0xff, words * sizeof *built);
        assert_int_equal(
            sph_bt_words(m.mem, &job, n, &sph_profiles[cases[i].profile], &written, &err), 0);
        assert_int_equal(written, lines);
        assert_memory_equal(m.mem, built, words * sizeof *built);
        free(built);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
}

/* A refit of spheres that did not move is what it was; of others, nothing but spheres changes. */
static void test_refit(void **unused) {
    (void)unused;
    for (int mode = SPH_BUILD_CURVE; mode <= SPH_BUILD_PAPER; mode++)
        for (int kind = 0; kind < DRAWN_KINDS; kind++) {
            enum { N = 77 };
            const struct sph_profile *p = &sph_profiles[SPH_STANDARD];
            struct sph_bt_kept kept = {0};
            struct sph_bt_job job;
            struct sph_error err;
            uint32_t written, again;
            static uint32_t built[sizeof memory / 4];
            draw((enum drawn_kind)kind, N, p, &job);
            job.mode = SPH_BUILD_REFIT, job.kept = &kept;
            assert_int_equal(sph_bt_words(memory, &job, MOST, p, &written, &err), SPH_BT_MODE);
            job.mode = mode;
            assert_int_equal(sph_bt_words(memory, &job, MOST, p, &written, &err), 0);
            memcpy(built, memory, sizeof memory);
            job.mode = SPH_BUILD_REFIT;
            assert_int_equal(sph_bt_words(memory, &job, MOST, p, &again, &err), 0);
            assert_int_equal(written, again);
            assert_memory_equal(built, memory, sizeof memory);

            drawn_spheres(DRAWN_SMALL, leaves, N, p, next, NULL);
            for (uint32_t id = 0; id < N; id++)
                drawn_record(memory + (size_t)(job.prim_base + id) * SPH_LINE_WORDS, id,
                             &leaves[id], 0);
            memcpy(before, memory, sizeof memory);
            assert_int_equal(sph_bt_words(memory, &job, MOST, p, &again, &err), 0);
            assert_int_equal(written, again);
            struct above up = {0};
            memset(&walk, 0, sizeof walk);
            walk.p = p, walk.job = &job, walk.end = job.root + written;
            check_below(job.root, &up);
            for (uint32_t line = job.root; line < walk.end; line++)
                if (line == job.root || walk.node[line])
                    assert_int_equal(memory[(size_t)line * SPH_LINE_WORDS + 7],
                                     built[(size_t)line * SPH_LINE_WORDS + 7]);
            job.n--; /* another number */
            assert_int_equal(sph_bt_words(memory, &job, MOST, p, &again, &err), SPH_BT_MODE);
            sph_bt_forget(&kept);
        }
}

int main(int argc, char **argv) {
    state = test_number(argc > 1 ? argv[1] : NULL, "argument 1", 1);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),  cmocka_unit_test(test_order), cmocka_unit_test(test_join),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_paper), cmocka_unit_test(test_refit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
