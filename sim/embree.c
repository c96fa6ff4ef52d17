/* embree.c - the rays of a machine's frame through Embree, the literal and the fast walk: times
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: embree MACHINE.sph [ROUNDS]       for make bench; JSON on standard output
 *
 * Rays are those that the golden model traces for the frame, in its order, one thread, one ray
 * after another. A time has all from origin and direction to the hit: the set-up of a ray too.
 * Embree has the spheres of the machine's grid, which floats of profile standard hold exactly; its
 * nearest hits by rtcIntersect1, hidden lights by rtcOccluded1 from just before the surface.
 */
#include <embree3/rtcore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/render.h"
#include "fast/setup.h"
#include "fast/fast.h"
#include "prim/sphere.h"

enum { EMBREE, LITERAL, FAST, WAYS, ROUNDS = 5, MOST_ROUNDS = 100 };

static const char *const names[WAYS] = {"embree", "literal", "fast"};

struct rays {
    const struct sph_machine *m;
    struct sph_ray_log log;
    RTCScene scene;
    struct sph_fast *fast;
    uint32_t *hit; /* of each ray the id, or SPH_ID_NONE; of a shadow ray 1 or 0 */
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

static void embree(struct rays *r, int i) {
    const struct sph_ray *ray = &r->log.rays[i].ray;
    struct RTCIntersectContext context;
    struct RTCRayHit hit = {
        .ray = {.org_x = (float)ray->org[0],
                .org_y = (float)ray->org[1],
                .org_z = (float)ray->org[2],
                .dir_x = (float)ray->dir[0],
                .dir_y = (float)ray->dir[1],
                .dir_z = (float)ray->dir[2],
                .tfar = ray->kind == SPH_SHADOW ? 1 : 1e30f,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID}};
    rtcInitIntersectContext(&context);
    if (ray->kind == SPH_SHADOW) {
        hit.ray.tnear = 1e-4f;
        rtcOccluded1(r->scene, &context, &hit.ray);
        r->hit[i] = hit.ray.tfar < 0;
    } else {
        rtcIntersect1(r->scene, &context, &hit);
        r->hit[i] = hit.hit.primID == RTC_INVALID_GEOMETRY_ID ? SPH_ID_NONE : hit.hit.primID;
    }
}

static void model(struct rays *r, int i, int way, struct sph_counters *c) {
    const struct sph_ray *from = &r->log.rays[i].ray;
    struct sph_ray ray = {.kind = from->kind, .skip = from->skip, .inside = from->inside};
    uint32_t visits = 0, errors = 0;
    memcpy(ray.org, from->org, sizeof ray.org);
    memcpy(ray.dir, from->dir, sizeof ray.dir);
    struct sph_hit hit;
    if (way == FAST) {
        sph_fast_prepare(&r->m->profile, &ray);
        hit = sph_fast_trace(r->fast, &ray, c, &visits, &errors);
    } else {
        sph_ray_setup(&r->m->profile, &ray);
        hit = sph_traverse(r->m, &ray, SPH_TRAVERSE_TREE, c, &visits, &errors);
    }
    r->hit[i] = ray.kind == SPH_SHADOW ? hit.key != 0 : hit.key ? hit.id : SPH_ID_NONE;
}

/* Seconds of all rays of a kind. */
static double trace(struct rays *r, int way, int kind) {
    struct sph_counters c = {{0}};
    double start = now();
    for (int i = 0; i < r->log.n; i++) {
        if (r->log.rays[i].ray.kind != kind) continue;
        if (way == EMBREE)
            embree(r, i);
        else
            model(r, i, way, &c);
    }
    return now() - start;
}

/* Rays of a kind, and those of them that end as in the model. */
static void agree(const struct rays *r, int kind, int *all, int *same) {
    *all = *same = 0;
    for (int i = 0; i < r->log.n; i++) {
        const struct sph_logged *l = &r->log.rays[i];
        if (l->ray.kind != kind) continue;
        ++*all;
        *same += r->hit[i] == (kind == SPH_SHADOW ? l->hit.key != 0
                               : l->hit.key       ? l->hit.id
                                                  : SPH_ID_NONE);
    }
}

int main(int argc, char **argv) {
    struct sph_error err = {{0}};
    struct sph_machine m;
    struct rays r = {.m = &m};
    struct sph_render_options how = {.traverse = SPH_TRAVERSE_TREE, .threads = 1, .log = &r.log};
    struct sph_frame frame;
    struct sph_counters counters = {{0}};
    int rounds = argc > 2 ? atoi(argv[2]) : ROUNDS;
    if (argc < 2 || rounds < 1 || rounds > MOST_ROUNDS)
        return fail("usage: embree MACHINE.sph [ROUNDS]");
    if (sph_machine_read(argv[1], &m, &err)) return fail(err.text);
    if (sph_machine_effect(&m, SPH_EFFECT_FACETS) || !(r.fast = sph_fast_new(&m, SPH_FAST_BEST)))
        return fail("for spheres in a tree of spheres alone");
    if (sph_render(&m, &how, &frame, &counters, &err) < 0) return fail(err.text);
    r.hit = r.log.full ? NULL : malloc((size_t)r.log.n * sizeof *r.hit);
    if (!r.hit) return fail("memory is out");
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    double start = now();
    r.scene = scene_of(device, &m);
    printf("{\"spheres\": %d, \"lanes\": \"%s\", \"embree_build\": %.6f", m.regs[SPH_REG_N_PRIMS],
           sph_fast_lanes(r.fast), now() - start);
    for (int kind = SPH_PRIMARY; kind <= SPH_SHADOW; kind++) {
        const char *of = kind == SPH_PRIMARY ? "primary" : "shadow";
        int all = 0, same = 0;
        double seconds[MOST_ROUNDS * WAYS] = {0};
        for (int i = 0; i < rounds * WAYS; i++) {
            seconds[i] = trace(&r, i % WAYS, kind);
            if (i % WAYS == EMBREE) agree(&r, kind, &all, &same);
        }
        printf(",\n \"%s\": {\"rays\": %d, \"same\": %d", of, all, same);
        for (int way = 0; way < WAYS; way++) {
            printf(", \"%s\": [", names[way]);
            for (int i = 0; i < rounds; i++)
                printf("%s%.6f", i ? ", " : "", seconds[i * WAYS + way]);
            printf("]");
        }
        printf("}");
    }
    printf("}\n");
    rtcReleaseScene(r.scene);
    rtcReleaseDevice(device);
    sph_fast_free(r.fast);
    sph_ray_log_free(&r.log);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    free(r.hit);
    return 0;
}
