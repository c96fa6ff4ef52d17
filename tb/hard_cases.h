/* hard_cases.h - the hard cases of another kind than spheres, as vectors of a bench
 * SPDX-License-Identifier: Apache-2.0
 *
 * The named cases of tests/hard first, then CASES generated ones of each family of the kind. Those
 * of a sphere and a facet are of facets here.
 *
 *     hard::Cases cases(b.seed, HARD_UNITS, [](const sph_profile &p) { return p.wd == BITS; });
 *     cases.limit(b);                             // HARD_CASE=80 alone: its vectors, at least one
 *     for (const hard::Vector &v : cases) ...     // none, if these are the words of no profile
 *     if (b.bad()) v.show();                      // its name, or the command that repeats it
 */
#ifndef SPH_TB_HARD_CASES_H
#define SPH_TB_HARD_CASES_H

#include <vector>

#include "hard.h"

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
