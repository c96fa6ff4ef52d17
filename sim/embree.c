/* embree.c - the rays of a machine's frame through Embree and the walks of the model: times
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: embree MACHINE.sph [ROUNDS]       for make bench; JSON on standard output
 *
 * Rays are those that the golden model traces for the frame, by tiles of pixels, shadow rays of a
 * tile by their lights: packets of the model, and one after another for the other ways, one thread.
 * A time has all from origin and direction to the hit: the set-up of a ray too.
 * Embree has the spheres of the machine's grid, which floats of profile standard hold exactly; its
 * nearest hits by rtcIntersect1, hidden lights by rtcOccluded1 from just before the surface.
 */
#include <embree3/rtcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "common/number.h"
#include "render/render.h"
#include "fast/prepare.h"
#include "fast/fast.h"
#include "fast/tile.h"
#include "prim/sphere.h"

enum { EMBREE, LITERAL, FAST, PACKET, WAYS, ROUNDS = 5, MOST_ROUNDS = 100 };

static const char *const names[WAYS] = {"embree", "literal", "fast", "packet"};

struct rays {
    const struct sph_machine *m;
    struct sph_ray_log log;
    RTCScene scene;
    struct sph_fast *fast;
    struct sph_bundle *bundles;                             /* of a kind */
    uint32_t (*expected)[SPH_PACKET], (*found)[SPH_PACKET]; /* ids, or SPH_ID_NONE; hidden: 1 */
    int n;
};

/* Seconds of processor that this thread had. */
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static int fail(const char *why) {
    fprintf(stderr, "embree: %s\n", why);
    return 1;
}

static RTCScene scene_of(RTCDevice device, const struct sph_machine *m) {
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    float *at = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                        4 * sizeof(float), n);
    for (uint32_t id = 0; id < n; id++) {
        struct sph_leaf s = sph_sphere_read(
            sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + (size_t)id), m->profile.w);
        for (int i = 0; i < 3; i++)
            at[4 * (size_t)id + (size_t)i] = (float)s.ctr[i];
        at[4 * (size_t)id + 3] = (float)s.rad;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

static uint32_t embree(RTCScene scene, const struct sph_bundle *rays, int i) {
    struct RTCIntersectContext context;
    struct RTCRayHit hit = {
        .ray = {.org_x = (float)rays->org[0][i],
                .org_y = (float)rays->org[1][i],
                .org_z = (float)rays->org[2][i],
                .dir_x = (float)rays->dir[0][i],
                .dir_y = (float)rays->dir[1][i],
                .dir_z = (float)rays->dir[2][i],
                .tfar = rays->kind == SPH_SHADOW ? 1 : 1e30f,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID}};
    rtcInitIntersectContext(&context);
    if (rays->kind == SPH_SHADOW) {
        hit.ray.tnear = 1e-4f;
        rtcOccluded1(scene, &context, &hit.ray);
        return hit.ray.tfar < 0;
    }
    rtcIntersect1(scene, &context, &hit);
    return hit.hit.primID == RTC_INVALID_GEOMETRY_ID ? SPH_ID_NONE : hit.hit.primID;
}

static uint32_t answer(int kind, const struct sph_hit *hit) {
    return kind == SPH_SHADOW ? hit->key != 0 : hit->key ? hit->id : SPH_ID_NONE;
}

static inline void start(struct sph_ray *ray, const struct sph_bundle *rays, int i) {
    ray->kind = rays->kind;
    ray->skip = rays->skip[i];
    ray->inside = rays->inside;
    ray->first = 0;
    for (int k = 0; k < 3; k++) {
        ray->org[k] = rays->org[k][i];
        ray->dir[k] = rays->dir[k][i];
        ray->lift[k] = 0;
    }
}

static uint32_t literal(const struct rays *r, const struct sph_bundle *rays, int i) {
    static struct sph_counters c;
    uint32_t visits = 0, errors = 0;
    struct sph_ray ray;
    start(&ray, rays, i);
    sph_ray_setup(&r->m->profile, &ray);
    struct sph_hit hit = sph_traverse(r->m, &ray, SPH_TRAVERSE_TREE, &c, &visits, &errors);
    return answer(rays->kind, &hit);
}

/* Rays from number `from` on, set up together as the tiles of a frame do, one after another. */
static void fast(const struct rays *r, int at, int from) {
    static struct sph_counters c;
    const struct sph_bundle *rays = &r->bundles[at];
    struct sph_ray some[SPH_TOGETHER];
    uint32_t visits = 0, errors = 0;
    int n = rays->n - from < SPH_TOGETHER ? rays->n - from : SPH_TOGETHER;
    for (int i = 0; i < n; i++)
        start(&some[i], rays, from + i);
    sph_fast_prepare_all(r->fast, some, n);
    for (int i = 0; i < n; i++) {
        struct sph_hit hit = sph_fast_trace(r->fast, &some[i], &c, &visits, &errors);
        r->found[at][from + i] = answer(rays->kind, &hit);
    }
}

/* Adds a ray to the packet that is the last one. */
static void add(struct rays *r, const struct sph_logged *logged) {
    struct sph_bundle *to = &r->bundles[r->n];
    const struct sph_ray *ray = &logged->ray;
    int i = to->n++;
    for (int k = 0; k < 3; k++) {
        to->org[k][i] = (int32_t)ray->org[k];
        to->dir[k][i] = (int32_t)ray->dir[k];
    }
    to->kind = ray->kind;
    to->inside = ray->inside;
    to->skip[i] = ray->skip;
    r->expected[r->n][i] = answer(ray->kind, &logged->hit);
}

/* Whether a shadow ray goes to light l: it has its direction. */
static int goes_to(const struct sph_machine *m, const struct sph_ray *ray, int l) {
    const int32_t *lamp = m->regs + SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE;
    int same = 1;
    for (int k = 0; k < 3; k++)
        same &= ray->dir[k] == lamp[k] - sph_round(ray->org[k], lamp[3] >> SPH_LIGHT_SHIFT_LSB);
    return same;
}

/* The packets of rays of a kind; 0 if memory is out. The frame has no pixel that is not traced. */
static int group(struct rays *r, int kind) {
    int width = r->m->regs[SPH_REG_FRAME_W], height = r->m->regs[SPH_REG_FRAME_H], n = 0;
    int lights = kind == SPH_SHADOW ? r->m->regs[SPH_REG_N_LIGHTS] : 1;
    size_t most = (size_t)((width / SPH_TILE + 1) * (height / SPH_TILE + 1) * lights);
    int *at = malloc(((size_t)width * (size_t)height + 1) * sizeof *at); /* of a pixel, its rays */
    r->bundles = calloc(most, sizeof *r->bundles);
    r->expected = calloc(most, sizeof *r->expected);
    r->found = calloc(most, sizeof *r->found);
    if (!at || !r->bundles || !r->expected || !r->found) return 0;
    for (int i = 0; i < r->log.n; i++)
        if (r->log.rays[i].ray.kind == SPH_PRIMARY) at[n++] = i;
    at[n] = r->log.n;
    r->n = 0;
    for (int tile = 0; tile < (int)most; tile++) {
        int across = width / SPH_TILE + 1, light = tile % lights;
        int tx = tile / lights % across * SPH_TILE, ty = tile / lights / across * SPH_TILE;
        for (int k = 0; k < SPH_PACKET; k++) {
            int x = tx + sph_tile_x(k), y = ty + sph_tile_y(k);
            if (x >= width || y >= height) continue;
            for (int i = at[y * width + x]; i < at[y * width + x + 1]; i++)
                if (r->log.rays[i].ray.kind == kind &&
                    (kind == SPH_PRIMARY || goes_to(r->m, &r->log.rays[i].ray, light)))
                    add(r, &r->log.rays[i]);
        }
        r->n += r->bundles[r->n].n > 0;
    }
    free(at);
    return 1;
}

static void packet(struct rays *r, int at) {
    const struct sph_bundle *rays = &r->bundles[at];
    struct sph_hit hits[SPH_PACKET];
    if (rays->kind == SPH_SHADOW) {
        uint64_t hidden = sph_packet_hidden(r->fast, rays);
        for (int i = 0; i < rays->n; i++)
            r->found[at][i] = hidden >> i & 1;
        return;
    }
    sph_packet_nearest(r->fast, rays, hits);
    for (int i = 0; i < rays->n; i++)
        r->found[at][i] = answer(rays->kind, &hits[i]);
}

/* Seconds of all rays. */
static double trace(struct rays *r, int way) {
    double start = now();
    for (int at = 0; at < r->n; at++) {
        const struct sph_bundle *rays = &r->bundles[at];
        if (way == PACKET) packet(r, at);
        for (int i = 0; i < rays->n && way == FAST; i += SPH_TOGETHER)
            fast(r, at, i);
        for (int i = 0; i < rays->n && (way == EMBREE || way == LITERAL); i++)
            r->found[at][i] = way == EMBREE ? embree(r->scene, rays, i) : literal(r, rays, i);
    }
    return now() - start;
}

/* Rays, and those of them that ended as in the model. */
static void agree(const struct rays *r, int *all, int *same) {
    *all = *same = 0;
    for (int at = 0; at < r->n; at++)
        for (int i = 0; i < r->bundles[at].n; i++)
            ++*all, *same += r->found[at][i] == r->expected[at][i];
}

int main(int argc, char **argv) {
    struct sph_error err = {{0}};
    struct sph_machine m;
    struct rays r = {.m = &m};
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_TREE, .threads = 1, .log = &r.log};
    struct sph_frame frame;
    struct sph_counters counters = {{0}};
    uint64_t asked = ROUNDS;
    if (argc < 2 || argc > 3 || (argc > 2 && sph_parse_count(argv[2], 1, MOST_ROUNDS, &asked)))
        return fail("usage: embree MACHINE.sph [ROUNDS], 1 to 100");
    int rounds = (int)asked;
    if (sph_machine_read(argv[1], &m, &err)) return fail(err.text);
    if (sph_machine_effect(&m, SPH_EFFECT_FACETS) || !(r.fast = sph_fast_new(&m, SPH_FAST_BEST)))
        return fail("for spheres in a tree of spheres alone");
    if (sph_render(&m, &how, &frame, &counters, &err) < 0) return fail(err.text);
    if (!sph_packets_fit(r.fast)) return fail("no packets for this machine");
    if (r.log.full) return fail("memory is out");
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    double start = now();
    r.scene = scene_of(device, &m);
    printf("{\"spheres\": %d, \"lanes\": \"%s\", \"embree_build\": %.6f", m.regs[SPH_REG_N_PRIMS],
           sph_fast_lanes(r.fast), now() - start);
    for (int kind = SPH_PRIMARY; kind <= SPH_SHADOW; kind++) {
        const char *of = kind == SPH_PRIMARY ? "primary" : "shadow";
        int all = 0, same = 0;
        double seconds[MOST_ROUNDS * WAYS] = {0};
        if (!group(&r, kind)) return fail("memory is out");
        for (int i = 0; i < rounds * WAYS; i++) {
            int whole = i % WAYS, equal;
            seconds[i] = trace(&r, whole);
            agree(&r, &all, whole == EMBREE ? &same : &equal);
            if (whole != EMBREE && equal != all) return fail("a walk finds something else");
        }
        printf(",\n \"%s\": {\"rays\": %d, \"same\": %d", of, all, same);
        for (int way = 0; way < WAYS; way++) {
            printf(", \"%s\": [", names[way]);
            for (int i = 0; i < rounds; i++)
                printf("%s%.6f", i ? ", " : "", seconds[i * WAYS + way]);
            printf("]");
        }
        printf("}");
        free(r.bundles), free(r.expected), free(r.found);
    }
    printf("}\n");
    rtcReleaseScene(r.scene);
    rtcReleaseDevice(device);
    sph_fast_free(r.fast);
    sph_ray_log_free(&r.log);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    return 0;
}
