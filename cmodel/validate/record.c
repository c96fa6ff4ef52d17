/* record.c - a register, and a leaf record of any tree; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "validate/prims.h"
#include "machine/records.h"
#include "validate/check.h"

int sph_validate_register(const struct sph_machine *m, int number, const char *name, int64_t lo,
                          int64_t hi, struct sph_error *err) {
    int32_t v = m->regs[number];
    if (v >= lo && v <= hi) return 0;
    return sph_fail(err, "register %s is %d, not in %lld..%lld", name, v, (long long)lo,
                    (long long)hi);
}

int sph_validate_record(const struct sph_machine *m, uint32_t base, uint32_t i, uint8_t *found,
                        struct sph_error *err) {
    int whole = sph_whole(m);
    uint32_t id, line = base + (whole ? i : i / 2);
    if (sph_validate_leaf(m, line, sph_record(m, whole, base, i), &id, err)) return -1;
    return found[id]++ ? sph_fail(err, "line %u: primitive %u stands twice", line, id) : 0;
}
