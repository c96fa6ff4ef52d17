/* nff_skip.h - the words of NFF files that are not rendered: reported or passed over
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_NFF_SKIP_H
#define SPH_SCENE_NFF_SKIP_H

#include "scene/nff_lex.h"

/* Deals with lex->token, which was taken and is none of the supported words. skip = 0: a
 * message that names it; always -1. skip = 1: passes over the whole record of a known word and
 * adds 1 to *n_skipped; -1 with a message if the record is cut short or the word is unknown. */
int sph_nff_skip(struct sph_lex *lex, int skip, uint32_t *n_skipped, struct sph_error *err);

#endif
