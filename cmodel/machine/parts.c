/* parts.c - see parts.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/parts.h"

#include <stdio.h>
#include <string.h>

#define PART(name, word, core, bit, most, all, option, needs, excludes, when, low, high, count,    \
             about)                                                                                \
    {#word, core, bit, most, all, option, needs, excludes, when, low, high, count, about},
const struct sph_part sph_parts[SPH_PARTS] = {SPH_EACH_PART(PART)};

static const char *const names[SPH_PARTS] = {
#define NAME(name, ...) #name,
    SPH_EACH_PART(NAME)};

int sph_part_asked(const struct sph_machine *m, int part) {
    const struct sph_part *p = &sph_parts[part];
    int asked = p->bit >= 0 && sph_machine_effect(m, p->bit);
    if (p->when >= 0) {
        asked = m->regs[p->when] >= p->low && m->regs[p->when] <= p->high;
        if (!asked) return 0;
    }
    return p->count >= 0 && m->regs[p->count] > asked ? m->regs[p->count] : asked;
}

/* "FIRST and INSIDE" of a mask. */
static void name_all(uint32_t mask, char *text, size_t size) {
    *text = 0;
    for (int i = 0; i < SPH_PARTS; i++) {
        size_t used = strlen(text);
        if (mask >> i & 1)
            snprintf(text + used, size - used, "%s%s", used ? " and " : "", names[i]);
    }
}

int sph_validate_effects(const struct sph_machine *m, struct sph_error *err) {
    int effects = m->regs[SPH_REG_EFFECTS];
    uint32_t have = 0;
    char list[256];
    if (effects < 0 || effects > SPH_EFFECT_MASK)
        return sph_fail(err, "register EFFECTS is %d, not in 0..%d", effects, SPH_EFFECT_MASK);
    for (int i = 0; i < SPH_REPORTS; i++)
        if (sph_parts[i].bit >= 0 && effects >> sph_parts[i].bit & 1) have |= 1u << i;
    for (int i = 0; i < SPH_REPORTS; i++) {
        const struct sph_part *p = &sph_parts[i];
        if (!(have >> i & 1)) continue;
        if (p->needs & ~have) {
            name_all(p->needs, list, sizeof list);
            return sph_fail(err, "register EFFECTS is %d: %s needs %s", effects, names[i], list);
        }
        if (p->excludes & have) {
            name_all(p->excludes, list, sizeof list);
            return sph_fail(err, "register EFFECTS is %d: %s excludes %s", effects, names[i], list);
        }
    }
    return 0;
}
