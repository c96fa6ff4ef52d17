/* check.h - the parts of sph_machine_validate()
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VALIDATE_CHECK_H
#define SPH_VALIDATE_CHECK_H

#include "machine/machine.h"

/* Checks lo <= register <= hi; the message names it. 0, or -1 with a message, as all of these. */
int sph_validate_register(const struct sph_machine *m, int number, const char *name, int64_t lo,
                          int64_t hi, struct sph_error *err);

/* Checks leaf record i of those from line `base` on, and that its primitive stands once: found[id],
 * of every primitive, counts. */
int sph_validate_record(const struct sph_machine *m, uint32_t base, uint32_t i, uint8_t *found,
                        struct sph_error *err);

/* The nodes of four children are a tree that holds every primitive once; those of a BIH too, each
 * record in one leaf, planes in none. Memory sizes have been checked. */
int sph_validate_tree(const struct sph_machine *m, struct sph_error *err);
int sph_validate_bih(const struct sph_machine *m, struct sph_error *err);

/* ---- the words of primitive records that refraction and Whitted's sum ask for ---- */

/* Whether REFRACT goes with the profile. 0, or -1 with a message.
 */
int sph_validate_optics(const struct sph_machine *m, struct sph_error *err);

/* Of a machine with REFRACT or SUM, whose primitive records lie in memory: shares, powers and
 * indices of refraction are in their ranges. 0, or -1 with a message. */
int sph_validate_materials(const struct sph_machine *m, struct sph_error *err);

/* ---- the part of validation that looks at mapping records and images ---- */

/* Of a machine with TEXTURE and valid primitive records: every tex is 0 or a record behind them,
 * with a known kind and the header of an image, all of whose levels lie in memory and behind each
 * other. 0, or -1 with a message. */
int sph_validate_textures(const struct sph_machine *m, struct sph_error *err);

#endif
