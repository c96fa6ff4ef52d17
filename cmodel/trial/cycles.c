/* cycles.c - see cycles.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/cycles.h"

#include <stddef.h>
#include <string.h>

#include "common/parallel.h"
#include "machine/parts.h"
#include "scene/rng.h"
#include "trial/draw.h"

enum { SIDE = 8 };               /* of a square */
static const double REST = 1.01; /* of the clocks: what cycles.h leaves out, by cycles.tsv */

struct sph_core_sizes sph_core_sizes_of(const struct sph_machine *m) {
#define STANDARD(NAME, standard) .NAME = (standard),
    struct sph_core_sizes s = {SPH_EACH_SIZE(STANDARD)};
    const struct sph_profile *p = sph_machine_profile(m);
    static const struct {
        int profile;
        size_t at;
        int64_t value;
    } paces[] = {
#define PACE(PROFILE, NAME, given) {SPH_##PROFILE, offsetof(struct sph_core_sizes, NAME), given},
        SPH_EACH_PACE(PACE)};
    for (size_t i = 0; i < sizeof paces / sizeof *paces; i++) {
        const struct sph_profile *of = &sph_profiles[paces[i].profile];
        size_t length = strcspn(p->name, ":");
        if (of->w != p->w || of->wd != p->wd || strlen(of->name) != length ||
            strncmp(of->name, p->name, length) != 0)
            continue;
        memcpy((char *)&s + paces[i].at, &paces[i].value, sizeof paces[i].value);
    }
    return s;
}

const char *sph_load_name(int load) {
#define TEXT(name, text, ...) text,
    static const char *const names[SPH_LOADS] = {SPH_EACH_LOAD(TEXT)};
    return names[load];
}

/* ---- one square ---- */

/* What is counted there, and what no counter has. */
struct work {
    struct sph_counters c;
    int64_t seen; /* pixels whose primary ray hits something */
};

static int64_t min(int64_t a, int64_t b) {
    return a < b ? a : b;
}

/* Clocks that each unit needs for it, unit by unit. */
static void loads(const struct sph_machine *m, const struct sph_core_sizes *s, const struct work *w,
                  double clocks[SPH_LOADS]) {
    static const int of_texture[] = {1, 4, 4, 8}; /* texels, by SPH_FILTER_* */
    const struct sph_profile *p = sph_machine_profile(m);
#define USE __attribute__((unused)) const int64_t
#define SIZE(NAME, standard) USE NAME = s->NAME;
#define PART(name, word, core, ...) USE has_##name = sph_part_asked(m, SPH_PART_##name);
#define COUNT(NAME, name) USE name = (int64_t)w->c.count[SPH_COUNT_##NAME];
#define UNIT(NAME, expression) USE NAME = (expression);
    SPH_EACH_SIZE(SIZE)
    SPH_EACH_PART(PART)
    USE W = p->w, WD = p->wd, PQ = p->pq, PR = p->pr, N_LIGHTS = m->regs[SPH_REG_N_LIGHTS];
    USE INTERPENETRATE = has_INTERPENETRATE, SUM = has_SUM, SMOOTH = has_SMOOTH, ACCEL = has_BIH,
        BOXES = has_BOXES;
    SPH_EACH_UNIT_COUNT(UNIT)
    SPH_EACH_RATE(UNIT)
    SPH_EACH_COUNTER(COUNT)
    USE later = rays_reflected + rays_refracted, rays = rays_primary + rays_shadow + later;
    USE vectors = rays_primary + later + quotients * (1 + N_LIGHTS);
    USE surfaces = later + w->seen, textured = texels / of_texture[m->regs[SPH_REG_TEX_FILTER]];
#define UNITS(name, text, units, all) ENGINES *(units),
#define CLOCKS(name, text, units, all) all,
    const int64_t many[SPH_LOADS] = {SPH_EACH_LOAD(UNITS)};
    const int64_t together[SPH_LOADS] = {SPH_EACH_LOAD(CLOCKS)};
    for (int l = 0; l < SPH_LOADS; l++)
        clocks[l] = (double)together[l] / (double)many[l];
}

/* ---- the window ---- */

struct job {
    const struct sph_core_sizes *sizes;
    struct sph_drawer drawer;
    int across; /* squares of the window, and how many there are */
    uint32_t all;
    uint32_t step; /* one of so many is drawn */
    struct sph_cycles *sum;
};

static uint64_t draw_square(const struct job *j, uint32_t square, struct work *w) {
    const int32_t *r = j->drawer.machine->regs;
    int left = r[SPH_REG_WIN_X0] + SIDE * (int)(square % (uint32_t)j->across);
    int top = r[SPH_REG_WIN_Y0] + SIDE * (int)(square / (uint32_t)j->across);
    int right = (int)min(left + SIDE, r[SPH_REG_WIN_X1]);
    int bottom = (int)min(top + SIDE, r[SPH_REG_WIN_Y1]);
    uint32_t errors = 0;
    struct sph_trail trail;
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++)
            w->seen += sph_drawer_pixel(&j->drawer, x, y, &w->c, &errors, &trail).id != SPH_ID_NONE;
    return (uint64_t)(right - left) * (uint64_t)(bottom - top);
}

static void draw_part(void *user, uint32_t first, uint32_t end) {
    const struct job *j = user;
    struct sph_cycles mine = {0};
    for (uint32_t i = first; i < end; i++) {
        struct work w = {{{0}}, 0};
        double clocks[SPH_LOADS];
        int most = 0;
        /* one of each run, where a random number has it: none behind the last */
        struct sph_rng rng = {i};
        uint32_t square = i * j->step + (uint32_t)(sph_rng_next(&rng) % j->step);
        if (square >= j->all) continue;
        mine.drawn += draw_square(j, square, &w);
        loads(j->drawer.machine, j->sizes, &w, clocks);
        for (int l = 1; l < SPH_LOADS; l++)
            if (clocks[l] > clocks[most]) most = l;
        for (int n = 0; n < SPH_COUNTERS; n++)
            mine.count[n] += (double)w.c.count[n];
        mine.frame += clocks[most];
        mine.binds[most] += clocks[most];
    }
    sph_parallel_lock();
    j->sum->frame += mine.frame;
    j->sum->drawn += mine.drawn;
    for (int i = 0; i < SPH_COUNTERS; i++)
        j->sum->count[i] += mine.count[i];
    for (int l = 0; l < SPH_LOADS; l++)
        j->sum->binds[l] += mine.binds[l];
    sph_parallel_unlock();
}

struct sph_cycles sph_cycles_expect(const struct sph_machine *m, const struct sph_core_sizes *sizes,
                                    uint32_t most, int threads) {
    enum { SQUARES = 4 }; /* that are worth a thread */
    struct sph_cycles c = {.most = -1};
    const int32_t *r = m->regs;
    int width = r[SPH_REG_WIN_X1] - r[SPH_REG_WIN_X0];
    int height = r[SPH_REG_WIN_Y1] - r[SPH_REG_WIN_Y0];
    if (width <= 0 || height <= 0) return c;
    struct job j = {.sizes = sizes, .drawer = sph_drawer_begin(m), .step = 1, .sum = &c};
    j.across = (width + SIDE - 1) / SIDE;
    j.all = (uint32_t)j.across * (uint32_t)((height + SIDE - 1) / SIDE);
    if (most) j.step = (uint32_t)min(j.all, ((int64_t)j.all * SIDE * SIDE - 1) / most + 1);
    int before = sph_parallel_most(threads);
    sph_parallel_for((j.all - 1) / j.step + 1, SQUARES, draw_part, &j);
    sph_parallel_most(before);
    sph_drawer_end(&j.drawer);
    c.pixel = REST * c.frame / (double)c.drawn;
    for (int i = 0; i < SPH_COUNTERS; i++)
        c.count[i] /= (double)c.drawn;
    for (int l = 0; l < SPH_LOADS; l++) {
        c.binds[l] /= c.frame > 0 ? c.frame : 1;
        if (c.most < 0 || c.binds[l] > c.binds[c.most]) c.most = l;
    }
    c.frame = c.pixel * width * height;
    return c;
}
