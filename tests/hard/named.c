/* named.c - runs the named cases: vectors, expectations, pairs through the tree; see named.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "exact.h"
#include "list.h"
#include "machine/machine.h"
#include "named.h"
#include "trace/setup.h"
#include "trace/traverse.h"

struct hard_case vector(const int64_t org[3], const int64_t dir[3], const int64_t ctr[3],
                        int64_t rad) {
    struct hard_case c;
    gen_start(&c);
    memcpy(c.ray.org, org, sizeof c.ray.org);
    memcpy(c.ray.dir, dir, sizeof c.ray.dir);
    memcpy(c.sphere[0].ctr, ctr, sizeof c.sphere[0].ctr);
    c.sphere[0].rad = rad;
    return c;
}

void require(struct named *n, int holds, const char *format, ...) {
    va_list args;
    if (holds || n->list || n->wrong++ > 3) return;
    va_start(args, format);
    fprintf(n->out, "  %s: ", n->p->name);
    vfprintf(n->out, format, args);
    fprintf(n->out, "\n");
    va_end(args);
}

/* x, y, z to y, z, x. */
static void turn(int64_t v[3]) {
    int64_t x = v[0];
    v[0] = v[1], v[1] = v[2], v[2] = x;
}

static void turn_case(struct hard_case *c) {
    turn(c->ray.org);
    turn(c->ray.dir);
    for (int i = 0; i < c->n; i++)
        turn(c->sphere[i].ctr);
}

/* Operands are those of the profile, or the vector itself is wrong. */
static void in_range(struct named *n, const struct hard_case *c) {
    int legal = gen_on_grid(n->p, c->ray.org);
    for (int i = 0; i < 3; i++)
        legal &= c->ray.dir[i] >= -n->most - 1 && c->ray.dir[i] <= n->most;
    for (int i = 0; i < c->n; i++)
        legal &= gen_on_grid(n->p, c->sphere[i].ctr) && c->sphere[i].rad >= 0 &&
                 c->sphere[i].rad < 2 * n->half;
    require(n, legal, "a vector is out of range");
    if (!legal && n->wrong < 5) hard_print(n->out, n->p, c);
}

void expect(struct named *n, struct hard_case c, int outcome, uint64_t key) {
    static const char *const names[] = {"", "miss", "near", "far", "exit"};
    for (int i = 0; i < 3; i++, turn_case(&c)) {
        FILE *say = n->wrong > 3 ? NULL : n->out;
        if (n->list) {
            hard_list_add(n->list, (struct hard_item){.what = HARD_RAY, .c = c});
            continue;
        }
        in_range(n, &c);
        n->wrong += hard_check(n->p, &c, 1, &n->tally, say);
        struct hard_case off = c;
        off.ray.inside = 0;
        n->wrong += hard_check(n->p, &off, 1, &n->tally, say);
        n->vectors++;
        struct sph_ray ray = c.ray;
        sph_ray_setup(n->p, &ray);
        struct sph_leaf_result r = sph_leaf_test(&ray, &c.sphere[0]);
        uint64_t roots = 0, got = 0;
        int is = !r.hit ? MISS : r.exit ? EXIT : r.far ? FAR : NEAR;
        if (r.hit && ray.kind != SPH_SHADOW && (r.exit || r.disc > 0))
            got = sph_leaf_key(&r, &roots);
        if ((outcome == ORACLE || is == outcome) && (!key || got == key)) continue;
        require(n, 0, "%s, key %lu, expected %s, key %lu", names[is], got, names[outcome], key);
        if (say) hard_print(say, n->p, &c);
    }
}

void expect_case(struct named *n, const struct hard_case *c) {
    n->vectors++;
    if (n->list)
        hard_list_add(n->list, (struct hard_item){.what = HARD_CASE, .c = *c});
    else
        n->wrong += hard_check(n->p, c, 1, &n->tally, n->wrong > 3 ? NULL : n->out);
}

/* a*t of a hit, rounded up; 0 for a miss. */
static uint64_t key_of(const struct exact *e) {
    return e->hit ? (uint64_t)(e->whole + (e->part > 0)) : 0;
}

void expect_first(struct named *n, struct hard_case c, int winner) {
    expect(n, c, ORACLE, 0);
    if (n->list) return;
    struct exact e[2] = {exact_leaf(&c.ray, &c.sphere[0]), exact_leaf(&c.ray, &c.sphere[1])};
    uint64_t key[2] = {key_of(&e[0]), key_of(&e[1])};
    if (winner < 0)
        require(n, key[0] == key[1], "the keys are not equal: %lu and %lu", key[0], key[1]);
    else
        require(n, e[winner].hit && (!e[1 - winner].hit || key[winner] < key[1 - winner]),
                "sphere %d is not the first: keys %lu and %lu", winner, key[0], key[1]);
    for (int order = 0; order < 4; order++) { /* of storage and of ids */
        uint32_t mem[4 * SPH_LINE_WORDS], visits = 0, errors = 0;
        int at = order & 1, first = winner;
        struct sph_machine m;
        struct sph_counters counters = {0};
        struct sph_leaf leaf[2] = {c.sphere[at], c.sphere[1 - at]};
        leaf[at].id = order >> 1 & 1; /* sphere 0 */
        leaf[1 - at].id = !leaf[at].id;
        if (winner < 0) first = leaf[at].id ? 1 : 0; /* which of them has id 0 */
        uint32_t id = key[0] || key[1] ? leaf[first ^ at].id : SPH_ID_NONE;
        two_leaves(n, leaf, mem, &m);
        sph_ray_setup(n->p, &c.ray);
        struct sph_hit tree =
            sph_traverse(&m, &c.ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
        struct sph_hit brute =
            sph_traverse(&m, &c.ray, SPH_TRAVERSE_BRUTE, &counters, &visits, &errors);
        require(n, !errors && tree.id == id && brute.id == id && tree.key == brute.key,
                "order %d: id %u in the tree, %u of all, expected %u", order, tree.id, brute.id,
                id);
        for (int kind = SPH_TREE_BIH; kind <= SPH_TREE_BRUTE; kind++) {
            uint32_t words[TWO_LINES * SPH_LINE_WORDS];
            two_in_bih(n, leaf, kind, words, &m);
            struct sph_hit bih =
                sph_traverse(&m, &c.ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
            require(n, !errors && bih.id == id && bih.key == brute.key,
                    "order %d: id %u in tree %d, expected %u", order, bih.id, kind, id);
        }
    }
}

struct named hard_named_start(int profile) {
    const struct sph_profile *p = &sph_profiles[profile];
    return (struct named){.p = p,
                          .profile = profile,
                          .half = gen_half(p),
                          .most = (1ll << (p->wd - 1)) - 1,
                          .scale = 1ll << (p->w - 12)};
}

int hard_named_run(int number, const char *scenes, FILE *out) {
    int failed = 0, count = number ? 1 : hard_n_named;
    fprintf(out, "1..%d\n", count);
    for (int i = 0; i < hard_n_named; i++) {
        int wrong = 0;
        uint64_t vectors = 0;
        char *text = NULL;
        size_t size = 0;
        if (number && number != i + 1) continue;
        FILE *lines = open_memstream(&text, &size);
        if (!lines) return 1;
        for (int profile = 0; profile < SPH_PROFILES; profile++) {
            struct named n = hard_named_start(profile);
            n.scenes = scenes;
            n.out = lines;
            hard_named[i].run(&n);
            wrong += n.wrong + !n.vectors;
            vectors += n.vectors;
        }
        fclose(lines);
        fprintf(out, "%s %d - %s (%lu vectors)\n%s", wrong ? "not ok" : "ok", i + 1,
                hard_named[i].name, vectors, text);
        free(text);
        failed += wrong != 0;
    }
    return failed;
}

/* A cell of a table: a bar would end it. */
static void print_cell(FILE *out, const char *text) {
    for (; *text; text++)
        fprintf(out, *text == '|' ? "\\%c" : "%c", *text);
    fprintf(out, " |");
}

void hard_named_list(FILE *out) {
    fprintf(out, "| | case | what for, and outcome |\n|---|---|---|\n");
    for (int i = 0; i < hard_n_named; i++) {
        fprintf(out, "| %d | ", i + 1);
        print_cell(out, hard_named[i].name);
        fprintf(out, " ");
        print_cell(out, hard_named[i].sentence);
        fprintf(out, "\n");
    }
    fprintf(out, "\n| family | kind | what is generated |\n|---|---|---|\n");
    for (int i = 0; i < HARD_FAMILIES; i++)
        fprintf(out, "| `%s` | %s | %s |\n", hard_families[i].name, hard_kinds[hard_families[i].of],
                hard_families[i].what);
}

/* ---- list ---- */

void hard_list_add(struct hard_list *list, struct hard_item item) {
    if (list->n == list->room) {
        size_t room = list->room ? 2 * list->room : 1024;
        struct hard_item *items = realloc(list->items, room * sizeof *items);
        if (!items) {
            perror("hard_list_add");
            exit(2);
        }
        list->items = items;
        list->room = room;
    }
    item.named = list->named;
    list->items[list->n++] = item;
}

struct hard_list hard_list_named(int profile) {
    struct hard_list list = {0};
    for (int i = 0; i < hard_n_named; i++) {
        struct named n = hard_named_start(profile);
        n.list = &list;
        list.named = i + 1;
        hard_named[i].run(&n);
    }
    return list;
}

const char *hard_named_name(int number) {
    return hard_named[number - 1].name;
}
