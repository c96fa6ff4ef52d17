/* nff_skip.h - the words of NFF files that are not rendered: reported or passed over
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_NFF_SKIP_H
#define SPH_SCENE_NFF_SKIP_H

#include "scene/nff_reader.h"

/* Deals with the reader's token, which was taken and is none of the supported words. r->skip = 0: a
 * message that names it; always -1. 1: passes over the whole record of a known word and notes it;
 * -1 with a message if the record is cut short or the word is unknown. */
int sph_nff_skip(struct sph_reader *r, struct sph_error *err);

#endif
