/* profile.c - see profile.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "machine/profile.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "machine/layout.h"

const struct sph_profile sph_profiles[SPH_PROFILES] = {SPH_PROFILE_TABLE};

static const struct width {
    const char *key;
    size_t at;
    int lsb, bits, min, max;
    const char *why; /* no more than max */
} widths[] = {SPH_WIDTH_TABLE};

enum { WIDTHS = sizeof widths / sizeof *widths };

static int get(const struct sph_profile *p, int i) {
    int value;
    memcpy(&value, (const char *)p + widths[i].at, sizeof value);
    return value;
}

static void set(struct sph_profile *p, int i, int value) {
    memcpy((char *)p + widths[i].at, &value, sizeof value);
}

int sph_profile_find(const char *name) {
    for (int i = 0; i < SPH_PROFILES; i++)
        if (!strcmp(name, sph_profiles[i].name)) return i;
    return -1;
}

/* Writes the name that the widths have. */
static void name_it(struct sph_profile *p) {
    int best = 0, least = WIDTHS + 1;
    for (int n = 0; n < SPH_PROFILES; n++) {
        int other = 0;
        for (int i = 0; i < WIDTHS; i++)
            other += get(p, i) != get(&sph_profiles[n], i);
        if (other < least) best = n, least = other;
    }
    size_t used = (size_t)snprintf(p->name, sizeof p->name, "%s", sph_profiles[best].name);
    const char *mark = ":";
    for (int i = 0; i < WIDTHS; i++) {
        if (get(p, i) == get(&sph_profiles[best], i)) continue;
        used += (size_t)snprintf(p->name + used, sizeof p->name - used, "%s%s=%d", mark,
                                 widths[i].key, get(p, i));
        mark = ",";
    }
}

uint32_t sph_profile_pack(const struct sph_profile *p) {
    uint32_t packed = 0;
    for (int i = 0; i < WIDTHS; i++)
        packed |= (uint32_t)get(p, i) << widths[i].lsb;
    return packed;
}

struct sph_profile sph_profile_unpack(uint32_t packed) {
    struct sph_profile p = {{0}, 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < WIDTHS; i++)
        set(&p, i, (int)(packed >> widths[i].lsb & ((1u << widths[i].bits) - 1)));
    name_it(&p);
    return p;
}

int64_t sph_min_screen(const struct sph_profile *p) {
    int bits = p->w + p->ng + 3 - p->pq, least = p->ng + 1;
    if (bits < least) bits = least;
    return bits > 4 ? 1ll << bits : SPH_MIN_SCREEN;
}

int sph_profile_check(const struct sph_profile *p, struct sph_error *err) {
    for (int i = 0; i < WIDTHS; i++) {
        const struct width *w = &widths[i];
        int v = get(p, i);
        if (v < w->min) return sph_fail(err, "%s is %d, not in %d..%d", w->key, v, w->min, w->max);
        if (v > w->max)
            return sph_fail(err, "%s is %d, not in %d..%d: %s", w->key, v, w->min, w->max, w->why);
    }
    if (p->wd < p->w + 1)
        return sph_fail(err, "wd is %d, w is %d: light - point needs w + 1 bits of direction",
                        p->wd, p->w);
    if (p->fw > p->w)
        return sph_fail(err, "fw is %d, w is %d: the filter sees the top fw of w bits", p->fw,
                        p->w);
    if (3 * p->w + 2 * p->wd > 126)
        return sph_fail(err,
                        "wd is %d, w is %d: num * a of a triangle has 3w + 2wd + 1 bits, at "
                        "most 127",
                        p->wd, p->w);
    if (p->pq + p->wd > 62)
        return sph_fail(err, "pq is %d, wd is %d: t * dir has at most 62 bits", p->pq, p->wd);
    if (p->pq < p->w + p->ng + 5 - p->wd)
        return sph_fail(err, "pq is %d: points of mirror rays need w + ng + 5 - wd = %d bits of t",
                        p->pq, p->w + p->ng + 5 - p->wd);
    if (p->pr && (p->pr < 4 || p->pr >= p->w + p->wd))
        return sph_fail(err, "pr is %d, neither 0 (all) nor in 4..%d", p->pr, p->w + p->wd - 1);
    return 0;
}

/* One key=value; *text moves behind it. */
static int parse_width(const char **text, struct sph_profile *p, unsigned *seen,
                       struct sph_error *err) {
    size_t length = strcspn(*text, "=,");
    int i = 0;
    while (i < WIDTHS && (strlen(widths[i].key) != length || memcmp(widths[i].key, *text, length)))
        i++;
    if (i == WIDTHS)
        return sph_fail(err, "'%.*s' is none of w, wd, pr, pq, ng and fw", (int)length, *text);
    if (*seen >> i & 1) return sph_fail(err, "%s is given twice", widths[i].key);
    *seen |= 1u << i;
    const char *at = *text + length;
    uint64_t value;
    if (sph_take_char(&at, '=') || sph_take_count(&at, 0, 999, &value) || (*at && *at != ','))
        return sph_fail(err, "%s has no number, as in %s=%d", widths[i].key, widths[i].key,
                        get(p, i));
    set(p, i, (int)value);
    *text = at;
    return 0;
}

int sph_profile_parse(const char *text, struct sph_profile *p, struct sph_error *err) {
    char name[16] = "";
    size_t length = strcspn(text, ":");
    struct sph_error why = {{0}};
    unsigned seen = 0;
    if (length < sizeof name) memcpy(name, text, length);
    int n = sph_profile_find(name);
    if (n < 0)
        return sph_fail(err,
                        "'%.100s' is none of draft, standard, fine, reference, nor one of "
                        "them with widths, NAME:key=value,...",
                        text);
    *p = sph_profiles[n];
    const char *at = text + length;
    while (*at) {
        at++; /* : or , */
        if (parse_width(&at, p, &seen, &why)) break;
    }
    if (p->pr == p->w + p->wd) p->pr = 0;
    if (why.text[0] || sph_profile_check(p, &why))
        return sph_fail(err, "profile %.100s: %.300s", text, why.text);
    name_it(p);
    return 0;
}
