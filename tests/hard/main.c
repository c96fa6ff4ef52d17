/* main.c - hard: hard cases, against oracles and floating point
 * SPDX-License-Identifier: Apache-2.0
 *
 * Exit code: 0 if ours is right everywhere, 1 if it is not, 2 for bad arguments or files.
 */
#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"
#include "common/number.h"
#include "named.h"

enum { FIRST = 256, CHUNKS, SHARE, STATE, JSON, LIST, NAMED, SCENES, PART, MERGE };

static const struct argp_option options[] = {
    {"cases", 'n', "N", 0, "generated cases a profile, spread over the families (100000)", 0},
    {"seed", 's', "S", 0, "seed of the generators (1)", 0},
    {"family", 'f', "NAME", 0, "this family alone, or those of this kind", 0},
    {"profile", 'p', "NAME", 0, "this profile alone", 0},
    {"processes", 'j', "N", 0, "processes at once (1)", 0},
    {"first", FIRST, "N", 0, "number of the first case: spreads a campaign (0)", 0},
    {"exhaustive", SHARE, "N", 0, "one in N of all operands of three bits; 0: none (1)", 0},
    {"chunks", CHUNKS, "N", 0, "end after N chunks of at most 65536 cases; with --state", 0},
    {"part", PART, "P/K", 0, "each K-th chunk from chunk P on, P below K; with --state", 0},
    {"merge", MERGE, 0, 0, "make the file of --state out of those of parts: FILE...", 0},
    {"state", STATE, "FILE", 0, "keep what is done here, and go on from there", 0},
    {"json", JSON, "FILE", 0, "write the table as JSON", 0},
    {"case", 'c', "F:P:N", 0, "one case of family F, profile P, in full", 1},
    {"named", NAMED, "N", OPTION_ARG_OPTIONAL, "the named cases, or case N, as TAP", 1},
    {"list", LIST, 0, 0, "named cases and families as tables", 1},
    {"scenes", SCENES, "FILE", 0, "scenes of the named cases (tests/hard/scenes.nff)", 1},
    {0}};

struct arguments {
    struct campaign campaign;
    const char *one, *json, *scenes;
    int list, named; /* named: -1 not asked for, 0 all */
    int merge;       /* 1: argv from `files` on, n_files of them, are put together */
    char **files;
    int n_files;
};

static uint64_t number(const char *text, const char *what, uint64_t most,
                       struct argp_state *state) {
    uint64_t n = 0;
    if (sph_parse_count(text, 0, most, &n))
        argp_error(state, "%s: %s is not a number from 0 to %lu", what, text, most);
    return n;
}

static int family_find(const char *name, size_t length) {
    for (int i = 0; i < HARD_FAMILIES; i++)
        if (strlen(hard_families[i].name) == length &&
            !strncmp(hard_families[i].name, name, length))
            return i;
    return -1;
}

/* A family, or all of a kind, which stand together; none if it is neither. */
static void families_find(const char *name, struct campaign *c) {
    c->family = family_find(name, strlen(name));
    c->families = c->family >= 0;
    for (int i = HARD_FAMILIES; i-- > 0;)
        if (!strcmp(hard_kinds[hard_families[i].of], name)) c->family = i, c->families++;
}

/* P/K */
static void part_of(const char *text, struct campaign *c, struct argp_state *state) {
    const char *at = text;
    if (sph_take_count(&at, 0, UINT64_MAX, &c->part) || sph_take_char(&at, '/') ||
        sph_parse_count(at, c->part + 1, UINT64_MAX, &c->parts))
        argp_error(state, "--part: %s is not P/K with P below K", text);
}

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    struct campaign *c = &a->campaign;
    switch (key) {
    case 'n':
        c->cases = number(arg, "--cases", UINT64_MAX, state);
        break;
    case 's':
        c->seed = number(arg, "--seed", UINT64_MAX, state);
        break;
    case FIRST:
        c->first = number(arg, "--first", UINT64_MAX, state);
        break;
    case SHARE:
        c->share = number(arg, "--exhaustive", UINT64_MAX, state);
        break;
    case CHUNKS:
        c->chunks = number(arg, "--chunks", UINT64_MAX, state);
        break;
    case 'j':
        c->processes = (int)number(arg, "--processes", 1024, state);
        if (c->processes < 1 || c->processes > 256)
            argp_error(state, "--processes: %s is not 1 to 256", arg);
        break;
    case 'f':
        families_find(arg, c);
        if (!c->families) argp_error(state, "no family or kind is called %s", arg);
        break;
    case 'p':
        c->profile = sph_profile_find(arg);
        if (c->profile < 0) argp_error(state, "no profile is called %s", arg);
        break;
    case PART:
        part_of(arg, c, state);
        break;
    case MERGE:
        a->merge = 1;
        break;
    case ARGP_KEY_ARGS:
        if (!a->merge) return ARGP_ERR_UNKNOWN;
        a->files = state->argv + state->next;
        a->n_files = state->argc - state->next;
        break;
    case ARGP_KEY_END:
        if ((a->merge || c->parts > 1) && !c->state)
            argp_error(state, "--merge and --part are with --state");
        break;
    case STATE:
        c->state = arg;
        break;
    case JSON:
        a->json = arg;
        break;
    case 'c':
        a->one = arg;
        break;
    case LIST:
        a->list = 1;
        break;
    case SCENES:
        a->scenes = arg;
        break;
    case NAMED:
        a->named = arg ? (int)number(arg, "--named", 65535, state) : 0;
        if (a->named > hard_n_named) argp_error(state, "there is no named case %s", arg);
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

/* --case FAMILY:PROFILE:NUMBER */
static int run_one(const struct arguments *a) {
    char profile[32] = "";
    const char *colon = strchr(a->one, ':'), *last = strrchr(a->one, ':');
    uint64_t n;
    int family = colon ? family_find(a->one, (size_t)(colon - a->one)) : -1;
    if (last > colon) snprintf(profile, sizeof profile, "%.*s", (int)(last - colon - 1), colon + 1);
    int p = sph_profile_find(profile);
    if (family < 0 || p < 0 || sph_parse_count(last + 1, 0, UINT64_MAX, &n)) {
        fprintf(stderr, "hard: --case: %s is not FAMILY:PROFILE:NUMBER\n", a->one);
        return 2;
    }
    struct hard_case c;
    struct hard_tally t = {0};
    hard_make(a->campaign.seed, family, p, n, &c);
    hard_print(stdout, &sph_profiles[p], &c);
    int wrong = hard_check(&sph_profiles[p], &c, 1, &t, stdout);
    printf("%s: %lu hits, %d wrong\n", a->one, t.hits, wrong);
    for (int i = 1; i < HARD_COLUMNS; i++)
        printf("%-17s wrong hit %lu, root %lu, order %lu, tie %lu, t off by %g\n", hard_columns[i],
               t.column[i].hit, t.column[i].root, t.column[i].order, t.column[i].tie,
               t.column[i].worst);
    return wrong ? 1 : 0;
}

/* --merge */
static int run_merge(struct arguments *a) {
    struct sph_error err = {{0}};
    if (!campaign_merge(&a->campaign, a->files, a->n_files, &err)) return 0;
    fprintf(stderr, "hard: %s\n", err.text);
    return 2;
}

static int run_campaign(struct arguments *a) {
    struct sph_error err = {{0}};
    struct campaign *c = &a->campaign;
    uint64_t wrong = 0, naive = 0;
    int left = campaign_run(c, &err);
    if (left < 0 || (a->json && report_json(c, a->json, &err))) {
        fprintf(stderr, "hard: %s\n", err.text);
        return 2;
    }
    for (int i = 0; i < HARD_ROWS; i++) {
        wrong += hard_tally_wrong(&c->row[i]);
        naive += c->row[i].naive;
    }
    report_table(c, stdout);
    if (left) printf("\nnot all of it yet: go on with the same command\n");
    printf("\nseed %lu, %lu cases a profile from number %lu; %lu answers of the naive model\n",
           c->seed, c->cases, c->first, naive);
    printf("%lu cases in %.1f s: %.2f million a second; %lu wrong\n", c->done, c->seconds,
           c->seconds > 0 ? (double)c->done / c->seconds / 1e6 : 0, wrong);
    return wrong ? 1 : 0;
}

int main(int argc, char **argv) {
    static const struct argp argp = {
        options, parse, "", "Hard cases: model, oracles, floating point.", 0, 0, 0};
    struct arguments a = {.named = -1, .scenes = "tests/hard/scenes.nff"};
    a.campaign = (struct campaign){.seed = 1,
                                   .cases = 100000,
                                   .share = 1,
                                   .families = HARD_FAMILIES,
                                   .profile = -1,
                                   .processes = 1,
                                   .chunks = UINT64_MAX,
                                   .parts = 1,
                                   .program = argv[0]};
    argp_err_exit_status = 2;
    if (argp_parse(&argp, argc, argv, 0, 0, &a)) return 2;
    if (a.list) {
        hard_named_list(stdout);
        return 0;
    }
    if (a.one) return run_one(&a);
    if (a.named >= 0) return hard_named_run(a.named, a.scenes, stdout) ? 1 : 0;
    return a.merge ? run_merge(&a) : run_campaign(&a);
}
