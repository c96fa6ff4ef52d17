/* hard.h - the hard cases of tests/hard as vectors of the benches
 * SPDX-License-Identifier: Apache-2.0
 *
 * First the named cases, then EACH generated ones of every family of spheres, and of those of a
 * sphere and a facet, of which the facet counts for pairs alone; hard.h has the others. Those
 * that have the effect INSIDE off come behind all others, and the named ones with them once more,
 * so that a bench has to switch but once.
 *
 *     hard::Source hard(
 *         b.seed, [](const sph_profile &p) { return p.w == W && p.wd == WD; },
 *         [](const hard::Case &c) { return c.is_ray; });     // what the unit takes
 *     hard::Case c;
 *     while (hard.next(c)) ...                    // never, if these are the words of no profile
 *     if (b.bad()) c.show();                      // its name, or the command that repeats it
 *     hard.report(b);                             // their number; fails if some were left over
 *
 * HARD_CASE=29 in the environment: named case 29 and nothing else. The bench leaves out its own
 * directed vectors (alone()) and ends behind the last of the case (limit(b)).
 */
#ifndef SPH_TB_HARD_H
#define SPH_TB_HARD_H

#include <cstring>
#include <memory>
#include <vector>

#include "bench.h"

extern "C" {
#include "tests/hard/list.h"
#include "prim/facet.h"
#include "prim/sphere.h"
#include "core/ray.h"
#include "trace/setup.h"
#include "tests/number.h"
}

namespace hard {

constexpr uint64_t EACH = 2000;

/* The named case that is driven alone; 0: everything is driven. */
inline int alone() {
    static const char *const number = getenv("HARD_CASE");
    static const int n = (int)test_number(number, "HARD_CASE", 0);
    return n;
}

/* What of a case a unit takes is there if it is not 0: disc, key, and dir with a normal. */
struct Case {
    int named = 0, family = 0, profile = 0;
    uint64_t seed = 0, number = 0;
    bool given = false, is_ray = false, is_point = false;
    sph_ray ray{}; /* is_ray, is_point: set up */
    sph_leaf leaf{};
    sph_leaf_result result{}; /* is_ray: of the model */
    bench::u128 disc = 0;     /* radicand */
    uint64_t key = 0, a = 0;  /* quotient; is_ray, is_point: of the hit */
    int64_t dir[3] = {}, normal[3] = {};
    bool mirrors = false; /* dir and normal are there */

    void show() const {
        if (named)
            printf("#   named case %d, %s: build/test/hard --named=%d\n", named,
                   hard_named_name(named), named);
        else if (given)
            printf("#   build/test/hard --seed %llu --case %s:%s:%llu\n", (unsigned long long)seed,
                   hard_families[family].name, sph_profiles[profile].name,
                   (unsigned long long)number);
    }
};

class Source {
  public:
    /* The profile is the first that the words of the bench belong to. */
    Source(uint64_t s, bool (*fits)(const sph_profile &), bool (*takes)(const Case &))
        : seed(s), wanted(takes) {
        while (profile < SPH_PROFILES && !fits(sph_profiles[profile]))
            profile++;
        if (profile < SPH_PROFILES) list = hard_list_named(profile);
        items.reset(list.items);
    }

    /* With HARD_CASE the bench checks as many vectors as the case has for it, at least one. */
    template <class Bench> void limit(Bench &b) {
        Case c;
        if (!alone()) return;
        while (next(c))
            ;
        b.target = named;
        at = 0;
        outside = false;
        named = 0;
        if (!b.target) b.fail("the case has no vector for this bench");
    }

    bool next(Case &c) {
        c = {};
        while (sphere < waiting.n || fetch()) {
            Case made = make(sphere++);
            if (!wanted(made)) continue;
            (made.named ? named : generated)++;
            c = made;
            return true;
        }
        return false;
    }

    /* The next two spheres of one ray, or sphere and facet, that both have a key. */
    bool next_pair(Case &one, Case &other) {
        while (fetch()) {
            bool tie = waiting.of == HARD_TIES;
            if (waiting.n != 2 && !tie) continue;
            one = make(0);
            other = tie ? make_facet() : make(1);
            sphere = 2;
            if (!one.key || !other.key) continue;
            (one.named ? named : generated)++;
            return true;
        }
        return false;
    }

    template <class Bench> void report(Bench &b) {
        Case left;
        if (profile == SPH_PROFILES) return;
        if (b.vectors == b.target && b.all_vectors && next(left)) {
            left.show();
            b.fail("not all hard cases were driven");
        }
        printf("# vectors of hard cases: %ld named, %ld generated\n", named, generated);
    }

  private:
    struct Free {
        void operator()(hard_item *p) const { free(p); }
    };
    uint64_t seed, number = 0;
    bool (*wanted)(const Case &);
    int profile = 0, family = 0, sphere = 0;
    bool outside = false; /* second round: INSIDE off */
    size_t at = 0;
    hard_list list{};
    std::unique_ptr<hard_item, Free> items;
    hard_case waiting{};
    hard_item item{};
    long named = 0, generated = 0;

    /* The next case of one or two spheres. */
    bool fetch() {
        sphere = waiting.n = 0;
        if (profile == SPH_PROFILES) return false;
        while (at < list.n) {
            item = items.get()[at++];
            if (alone() && item.named != alone()) continue;
            waiting = item.c;
            if (item.what == HARD_CASE && waiting.of == HARD_TIES) item.what = HARD_RAY;
            if (item.what != HARD_RAY) waiting.n = !outside;
            if (outside) waiting.ray.inside = 0;
            if (waiting.n) return true;
        }
        item = {};
        if (alone()) family = HARD_FAMILIES;
        do {
            if (number == EACH) family++, number = 0;
            while (family < HARD_FAMILIES && hard_families[family].of != HARD_SPHERES &&
                   hard_families[family].of != HARD_TIES)
                family++;
            if (family == HARD_FAMILIES) {
                waiting.n = 0;
                if (outside) return false;
                outside = true;
                family = 0;
                at = 0;
                return fetch();
            }
            hard_make(seed, family, profile, number++, &waiting);
        } while (waiting.ray.inside == outside);
        return true;
    }

    /* Of a sphere and a facet, what the facet has: its key. */
    Case make_facet() {
        Case c = make(0);
        uint64_t divisions = 0;
        sph_facet_result r = sph_facet_test(&sph_profiles[profile], &c.ray, &waiting.facet[0]);
        c.key = r.hit && c.ray.kind != SPH_SHADOW ? sph_facet_key(&c.ray, &r, &divisions) : 0;
        c.result.far = r.far;
        return c;
    }

    Case make(int which) {
        const sph_profile &p = sph_profiles[profile];
        Case c;
        c.given = true;
        c.named = item.named;
        c.family = family;
        c.profile = profile;
        c.seed = seed;
        c.number = number - 1;
        c.disc = item.x;
        c.key = item.key;
        c.a = item.a;
        c.mirrors = item.what == HARD_MIRROR;
        memcpy(c.dir, item.dir, sizeof c.dir);
        memcpy(c.normal, item.normal, sizeof c.normal);
        if (item.what != HARD_RAY && item.what != HARD_POINT_AT) return c;

        uint64_t roots = 0;
        sph_surface s;
        c.is_ray = item.what == HARD_RAY;
        c.is_point = !c.is_ray;
        c.ray = waiting.ray;
        c.leaf = waiting.sphere[which];
        sph_ray_setup(&p, &c.ray);
        c.a = c.ray.a;
        if (c.is_ray) c.result = sph_leaf_test(&c.ray, &c.leaf);
        if (c.is_ray && !c.result.hit) return c;
        if (c.result.disc > 0) c.disc = (bench::u128)c.result.disc;
        if (c.ray.kind == SPH_SHADOW || !c.a) return c;
        if (c.is_ray && !c.result.exit && c.result.disc <= 0) return c;
        if (c.is_ray) c.key = sph_leaf_key(&c.result, &roots);
        sph_hit hit = {c.key, c.leaf.id, c.result.far != 0, 0};
        sph_surface_at(&p, &c.ray, &hit, &c.leaf, &s);
        c.mirrors = true;
        memcpy(c.dir, c.ray.dir, sizeof c.dir);
        memcpy(c.normal, s.normal, sizeof c.normal);
        return c;
    }
};

} // namespace hard

/* ---- the hard cases of another kind than spheres, as vectors of a bench ---- */
/* The named cases of tests/hard first, then CASES generated ones of each family of the kind. Those
 * of a sphere and a facet are of facets here.
 *
 *     hard::Cases cases(b.seed, HARD_UNITS, [](const sph_profile &p) { return p.wd == BITS; });
 *     cases.limit(b);                             // HARD_CASE=80 alone: its vectors, at least one
 *     for (const hard::Vector &v : cases) ...     // none, if these are the words of no profile
 *     if (b.bad()) v.show();                      // its name, or the command that repeats it */

namespace hard {

constexpr uint64_t CASES = 500;

struct Vector {
    hard_case c{};
    int named = 0, family = -1, profile = 0;
    uint64_t seed = 0, number = 0;

    void show() const {
        if (named)
            printf("#   named case %d, %s: build/test/hard --named=%d\n", named,
                   hard_named_name(named), named);
        else if (family >= 0)
            printf("#   build/test/hard --seed %llu --case %s:%s:%llu\n", (unsigned long long)seed,
                   hard_families[family].name, sph_profiles[profile].name,
                   (unsigned long long)number);
    }
};

class Cases {
  public:
    Cases(uint64_t seed, int kind, bool (*fits)(const sph_profile &)) {
        int profile = 0;
        while (profile < SPH_PROFILES && !fits(sph_profiles[profile]))
            profile++;
        if (profile == SPH_PROFILES) return;
        hard_list list = hard_list_named(profile);
        for (size_t i = 0; i < list.n; i++)
            add(list.items[i], kind, profile);
        free(list.items);
        named = all.size();
        for (int f = 0; f < HARD_FAMILIES && !alone(); f++)
            for (uint64_t i = 0; i < CASES && is_of(hard_families[f].of, kind); i++) {
                Vector v;
                v.family = f, v.profile = profile, v.seed = seed, v.number = i;
                hard_make(seed, f, profile, i, &v.c);
                all.push_back(v);
            }
        printf("# vectors of hard cases: %zu named, %zu generated\n", named, all.size() - named);
    }

    template <class Bench> void limit(Bench &b) const {
        if (!alone()) return;
        b.target = (long)named;
        if (!named) b.fail("the case has no vector for this bench");
    }
    std::vector<Vector>::const_iterator begin() const { return all.begin(); }
    std::vector<Vector>::const_iterator end() const { return all.end(); }

  private:
    std::vector<Vector> all;
    size_t named = 0;

    static bool is_of(int of, int kind) {
        return of == kind || (of == HARD_TIES && kind == HARD_FACETS);
    }

    /* A bent ray has a direction and a normal: both are vectors to make units of. */
    void add(const hard_item &item, int kind, int profile) {
        Vector v;
        if (alone() && item.named != alone()) return;
        v.named = item.named;
        v.profile = profile;
        v.c = item.c;
        bool bent = item.what == HARD_REFRACT;
        if (bent && kind == HARD_REFRACTION) {
            v.c.from = item.from;
            v.c.to = item.to;
            memcpy(v.c.ray.dir, item.dir, sizeof v.c.ray.dir);
        }
        if (bent && (kind == HARD_REFRACTION || kind == HARD_UNITS)) {
            memcpy(v.c.v, item.normal, sizeof v.c.v);
            all.push_back(v);
        } else if (item.what == HARD_CASE && is_of(item.c.of, kind)) {
            all.push_back(v);
        }
    }
};

} // namespace hard

#endif
