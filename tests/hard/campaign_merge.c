/* campaign_merge.c - parts of a campaign that were done apart, put together; see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "campaign.h"

/* One file more: its rows are added, its chunks marked. one: room for them. */
static int add(struct campaign *c, struct campaign *part, uint8_t *done, uint8_t *one,
               uint64_t chunks, struct sph_error *err) {
    memset(part->row, 0, sizeof part->row);
    int rc = campaign_load(part, one, chunks, err);
    if (rc) return rc < 0 ? -1 : sph_fail(err, "%s: no such file", part->state);
    for (uint64_t i = 0; i < chunks; i++) {
        if (done[i] && one[i])
            return sph_fail(err, "%s: chunk %lu is in a file before it", part->state, i);
        done[i] |= one[i];
    }
    for (int i = 0; i < HARD_ROWS; i++)
        hard_tally_add(&c->row[i], &part->row[i]);
    return 0;
}

int campaign_merge(struct campaign *c, char *const *files, int n, struct sph_error *err) {
    uint64_t chunks = campaign_chunks(c);
    uint8_t *done = calloc(chunks + 1, 1), *one = calloc(chunks + 1, 1);
    struct campaign *part = malloc(sizeof *part);
    int rc = done && one && part ? 0 : sph_fail(err, "no memory for %lu chunks", chunks);
    memset(c->row, 0, sizeof c->row);
    for (int i = 0; i < n && !rc; i++) {
        *part = *c;
        part->state = files[i];
        rc = add(c, part, done, one, chunks, err);
    }
    if (!rc) rc = campaign_save(c, done, chunks, err);
    free(part);
    free(one);
    free(done);
    return rc;
}
