/* aff_keys.c - keyframes of a transform: `k`; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/aff_reader.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *word;
    int track;
} tracks[] = {{"transl", SPH_AFF_MOVE},
              {"rot", SPH_AFF_TURN},
              {"scale", SPH_AFF_SCALE},
              {"visibility", SPH_AFF_SEEN},
              {"visible", SPH_AFF_SEEN}};
enum { N_WORDS = sizeof tracks / sizeof tracks[0] };

/* time, then 0 or 1, or x y z [degrees] tension continuity bias */
static int take_key(struct sph_aff *a, const char *word, int track, struct sph_key *key,
                    struct sph_error *err) {
    static const char *const shape[] = {"tension", "continuity", "bias"};
    double value[3];
    if (sph_lex_number(&a->r.lex, word, "time", &key->time, err)) return -1;
    if (track == SPH_AFF_SEEN)
        return sph_lex_number(&a->r.lex, word, "visible or not", &key->at.x, err);
    if (sph_nff_vec(&a->r, word, &key->at, err) ||
        (track == SPH_AFF_TURN && sph_lex_number(&a->r.lex, word, "degrees", &key->degrees, err)))
        return -1;
    if (track == SPH_AFF_TURN && key->degrees != 0 && !(sph_vec_length(key->at) > 0))
        return sph_nff_fail(&a->r, err, word, "the axis is zero");
    if (sph_nff_numbers(&a->r, word, shape, 3, value, err)) return -1;
    key->tension = value[0], key->continuity = value[1], key->bias = value[2];
    return 0;
}

static int take_track(struct sph_aff *a, const char *word, int track, struct sph_aff_track *t,
                      struct sph_error *err) {
    uint32_t n, line = a->r.lex.token_line;
    if (t->n) return sph_nff_fail(&a->r, err, word, "given twice");
    if (sph_aff_count(a, word, "number of keys", 0, SPH_AFF_COUNT, &n, err)) return -1;
    if (n < (track == SPH_AFF_SEEN ? 1 : SPH_SPLINE_MIN))
        return sph_fail(err, "%s:%u: `%s`: %u keys; %s", a->r.lex.path, line, word, n,
                        track == SPH_AFF_SEEN ? "one is the least" : "a spline has 4 or more");
    for (; t->n < n; t->n++) {
        struct sph_key *now;
        if (sph_aff_room(a, &t->key, t->n, sizeof *t->key, err)) return -1;
        now = &t->key[t->n];
        *now = (struct sph_key){.time = 0};
        if (take_key(a, word, track, now, err)) return -1;
    }
    return 0;
}

/* What is no word of a track: mostly a key more than was said. */
static int fail_word(struct sph_aff *a, const char *last, struct sph_error *err) {
    const char *path = a->r.lex.path;
    uint32_t line = a->r.lex.token_line;
    if (last && sph_lex_numeric(&a->r.lex))
        return sph_fail(err, "%s:%u: `%s`: `%s` is a number more than the keys it says it has",
                        path, line, last, sph_lex_printable(&a->r.lex));
    return sph_fail(err, "%s:%u: `k`: `%s` is none of transl, rot, scale, visibility and }", path,
                    line, sph_lex_printable(&a->r.lex));
}

static int take_tracks(struct sph_aff *a, struct sph_aff_keys *k, struct sph_error *err) {
    const char *last = NULL;
    for (int got; (got = sph_lex_peek(&a->r.lex, err)) != 0;) {
        if (got < 0) return -1;
        sph_lex_take(&a->r.lex);
        if (!strcmp(a->r.lex.token, "}")) return 0;
        int i = 0;
        while (i < N_WORDS && strcmp(a->r.lex.token, tracks[i].word) != 0)
            i++;
        if (i == N_WORDS) return fail_word(a, last, err);
        last = tracks[i].word;
        if (take_track(a, last, tracks[i].track, &k->track[tracks[i].track], err)) return -1;
    }
    return sph_fail(err, "%s:%u: the file ends within `k`, before }", a->r.lex.path,
                    a->r.lex.token_line);
}

/* Whether a name's keys, the newest of all, say the same as older ones. */
static int repeated(const struct sph_aff_keys *old, const struct sph_aff_keys *k) {
    for (int i = 0; i < SPH_AFF_TRACKS; i++) {
        const struct sph_aff_track *p = &old->track[i], *q = &k->track[i];
        if (p->n != q->n || (p->n && memcmp(p->key, q->key, p->n * sizeof *p->key) != 0)) return 0;
    }
    return 1;
}

/* k NAME { transl N keys, rot N keys, scale N keys, visibility N keys }: as many as there are */
int sph_aff_take_k(struct sph_aff *a, struct sph_error *err) {
    uint32_t line = a->r.lex.token_line;
    if (sph_aff_room(a, &a->keys, a->n_keys, sizeof *a->keys, err)) return -1;
    struct sph_aff_keys *k = &a->keys[a->n_keys++];
    memset(k, 0, sizeof *k);
    if (sph_aff_name(a, "k", "name", k->name, err) || sph_aff_brace(a, "k", err) ||
        take_tracks(a, k, err))
        return -1;
    for (struct sph_aff_keys *old = a->keys; old < k; old++)
        if (!strcmp(old->name, k->name) && !repeated(old, k))
            return sph_fail(err, "%s:%u: second `k` of %s, with other keys", a->r.lex.path, line,
                            k->name);
    return 0;
}
