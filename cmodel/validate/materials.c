/* materials.c - see materials.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/materials.h"

#include <stddef.h>

enum { ONE = 256 }; /* a share, u1.8 */

int sph_validate_optics(const struct sph_machine *m, struct sph_error *err) {
    int wd = sph_machine_profile(m)->wd;
    if (!sph_machine_effect(m, SPH_EFFECT_REFRACT) || wd <= SPH_REFRACT_WD) return 0;
    return sph_fail(err, "register EFFECTS is %d: REFRACT with WD %d, at most %d",
                    m->regs[SPH_REG_EFFECTS], wd, SPH_REFRACT_WD);
}

/* A field of the record of primitive id lies in low..high. */
static int in_range(uint32_t id, const char *name, uint32_t value, uint32_t low, uint32_t high,
                    struct sph_error *err) {
    if (value >= low && value <= high) return 0;
    return sph_fail(err, "primitive %u: %s is %u, not in %u..%u", id, name, value, low, high);
}

#define FIELD(name) sph_field(prim, SPH_PRIM_##name##_LSB, SPH_PRIM_##name##_BITS)

static int check_prim(const uint32_t *prim, uint32_t id, struct sph_error *err) {
    uint32_t kr = FIELD(KR), kt = FIELD(KT), sum = FIELD(SUM);
    if (in_range(id, "kr", kr, 0, ONE, err) || in_range(id, "kt", kt, 0, ONE, err) ||
        in_range(id, "ka", FIELD(KA), 0, ONE, err) || in_range(id, "kd", FIELD(KD), 0, ONE, err))
        return -1;
    if (!sum && in_range(id, "kr + kt", kr + kt, 0, ONE, err)) return -1;
    if (FIELD(KS) && in_range(id, "power", FIELD(POWER), SPH_POWER_ONE * SPH_SHINE_MIN,
                              SPH_POWER_ONE * SPH_SHINE_MAX, err))
        return -1;
    return kt ? in_range(id, "index", FIELD(INDEX), SPH_INDEX_MIN, SPH_INDEX_MAX, err) : 0;
}

int sph_validate_materials(const struct sph_machine *m, struct sph_error *err) {
    if (!sph_machine_effect(m, SPH_EFFECT_REFRACT) && !sph_machine_effect(m, SPH_EFFECT_SUM))
        return 0;
    for (uint32_t id = 0; id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++) {
        size_t line = (size_t)m->regs[SPH_REG_PRIM_BASE] + id;
        if (check_prim(sph_line(m, line), id, err)) return -1;
    }
    return 0;
}
