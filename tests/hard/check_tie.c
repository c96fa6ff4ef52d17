/* check_tie.c - a sphere and a facet on one ray: which one comes first; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "check.h"
#include "facet.h"
#include "naive/hit.h"
#include "trace/traverse.h"

/* What the ray meets through a node of both, the sphere of id 0 and the facet of id 1, by the keys
 * of the oracles: of equal ones the sphere. */
static void check_first(struct job *j, const struct sphere_answer *s,
                        const struct facet_answer *f) {
    struct named n = hard_named_start((int)(j->p - sph_profiles));
    struct sph_leaf sphere = j->c->sphere[0];
    const struct sph_facet_leaf *const both[2] = {NULL, &j->c->facet[0]};
    const uint32_t ids[2] = {0, 1};
    uint64_t near = s->exact.exit ? 1 : (uint64_t)(s->exact.whole + (s->exact.part > 0));
    uint64_t far = f->exact.key;
    int shadow = j->ray.kind == SPH_SHADOW, hit = s->exact.hit || f->exact.hit;
    uint32_t id = s->exact.hit && (!f->exact.hit || near <= far) ? 0 : 1;
    struct sph_ray ray = j->ray;
    if (ray.skip.id != SPH_ID_NONE) ray.skip.id = ray.skip.id != sphere.id;
    sphere.id = 0;
    for (int order = 0; order < 2; order++) {
        uint32_t mem[TWO_RECORDS * SPH_LINE_WORDS], visits = 0, errors = 0;
        struct sph_counters counters = {0};
        struct sph_machine m;
        two_records(&n, both, &sphere, order, ids, mem, &m);
        for (int how = SPH_TRAVERSE_TREE; how <= SPH_TRAVERSE_BRUTE; how++) {
            struct sph_hit got = sph_traverse(&m, &ray, how, &counters, &visits, &errors);
            if (errors || !got.key != !hit || (hit && !shadow && got.id != id))
                job_wrong(j, HARD_TREE, how ? "another hit of all" : "another hit in a node");
        }
        if (!j->naive || order) continue;
        struct sph_naive_found found = sph_naive_trace(&m, &ray);
        if (!found.how.hit != !hit || (hit && !shadow && found.prim.facet != (int)id))
            job_wrong(j, HARD_NAIVE, "the first of a sphere and a facet");
    }
}

void check_ties(struct job *j) {
    struct sphere_answer s = {0};
    struct facet_answer f = {0};
    check_sphere(j, &j->c->sphere[0], &s);
    check_facet(j, &j->c->facet[0], &f);
    check_first(j, &s, &f);
    if (!s.exact.root || !f.exact.hit || f.exact.ended || j->ray.kind == SPH_SHADOW) return;
    const uint64_t key[2] = {s.key, f.key};
    sph_i128 scaled = f.exact.num * (sph_i128)j->ray.a, det = f.exact.det;
    int floats = j->ray.skip.id == SPH_ID_NONE && j->ray.inside;
    job_order(j, exact_against(&s.exact, (int64_t)(scaled / det), scaled % det, det), key,
              floats ? s.floats : NULL, f.floats);
}
