/* campaign.c - see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "campaign.h"
#include "common/file.h"
#include "common/number.h"
#include "tool/progress.h"

enum { MOST_PROCESSES = 256, MOST_SHOWN = 20 /* mistakes printed */ };

struct chunk { /* family < 0: a slice of the exhaustive part */
    int family, profile, slice;
    uint64_t first, count;
};

struct message {
    uint64_t chunk;
    struct hard_tally tally;
};

/* What the processes share. */
struct shared {
    uint64_t next, taken, shown;
};

/* Counts on: returns what *counter was. */
static uint64_t next_of(uint64_t *counter) {
    return __atomic_fetch_add(counter, 1, __ATOMIC_RELAXED);
}

static uint64_t profiles_of(const struct campaign *c) {
    return c->profile < 0 ? SPH_PROFILES : 1;
}

uint64_t campaign_family_cases(const struct campaign *c) {
    uint64_t families = (uint64_t)c->families;
    return (c->cases + families - 1) / families;
}

static uint64_t slices(const struct campaign *c) {
    return c->share ? HARD_SLICES : 0;
}

uint64_t campaign_chunks(const struct campaign *c) {
    uint64_t rows = (uint64_t)c->families * profiles_of(c);
    uint64_t blocks = (campaign_family_cases(c) + HARD_BLOCK - 1) / HARD_BLOCK;
    return slices(c) + blocks * rows;
}

static struct chunk chunk_at(const struct campaign *c, uint64_t i) {
    if (i < slices(c)) return (struct chunk){.family = -1, .slice = (int)i};
    i -= slices(c);
    uint64_t profiles = profiles_of(c), families = (uint64_t)c->families;
    uint64_t block = i / (families * profiles), left;
    struct chunk k = {.profile = c->profile};
    if (k.profile < 0) k.profile = (int)(i % profiles);
    k.family = c->family + (int)(i / profiles % families);
    left = campaign_family_cases(c) - block * HARD_BLOCK;
    k.first = c->first + block * HARD_BLOCK;
    k.count = left < HARD_BLOCK ? left : HARD_BLOCK;
    return k;
}

static int row_of(const struct chunk *k) {
    return k->family < 0 ? HARD_ROWS - 1 : k->family * SPH_PROFILES + k->profile;
}

/* One chunk; mistakes go to `out`, with the command that repeats them. */
static void run_chunk(const struct campaign *c, const struct chunk *k, struct shared *shared,
                      struct hard_tally *t, FILE *out) {
    if (k->family < 0) {
        hard_exhaustive(k->slice, c->share, t, out);
        return;
    }
    for (uint64_t i = k->first; i < k->first + k->count; i++) {
        struct hard_case one;
        struct hard_tally unused = {0};
        int naive = i % HARD_NAIVE_SHARE == 0;
        hard_make(c->seed, k->family, k->profile, i, &one);
        if (!hard_check(&sph_profiles[k->profile], &one, naive, t, NULL)) continue;
        if (next_of(&shared->shown) >= MOST_SHOWN) continue;
        hard_check(&sph_profiles[k->profile], &one, naive, &unused, out);
        fprintf(out, "  repeat: %s --seed %lu --case %s:%s:%lu\n", c->program, c->seed,
                hard_families[k->family].name, sph_profiles[k->profile].name, i);
    }
}

static int is_of_part(const struct campaign *c, uint64_t chunk) {
    return chunk % c->parts == c->part;
}

/* A process: takes chunks until none is left, sends what came of each. */
static void work(const struct campaign *c, struct shared *shared, const uint8_t *done,
                 uint64_t chunks, int to) {
    uint64_t i;
    while ((i = next_of(&shared->next)) < chunks) {
        if (done[i] || !is_of_part(c, i)) continue;
        if (next_of(&shared->taken) >= c->chunks) break;
        struct chunk k = chunk_at(c, i);
        struct message m = {.chunk = i};
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        if (!out) _exit(1);
        run_chunk(c, &k, shared, &m.tally, out);
        if (fclose(out) || (size && write(STDOUT_FILENO, text, size) != (ssize_t)size)) _exit(1);
        free(text);
        if (write(to, &m, sizeof m) != sizeof m) _exit(1); /* below PIPE_BUF: in one piece */
    }
    _exit(0);
}

/* Takes what the processes send. */
static int gather(struct campaign *c, uint8_t *done, uint64_t chunks, int from,
                  struct sph_error *err) {
    struct message m;
    struct progress progress;
    double start = progress_now(), saved = start;
    uint64_t finished = 0, now = 0, goal = 0;
    int show = progress_start(&progress, "hard cases", 0), failed = 0;
    for (uint64_t i = 0; i < chunks; i++)
        finished += done[i], goal += !done[i] && is_of_part(c, i);
    while (!failed && read(from, &m, sizeof m) == sizeof m) {
        struct chunk k = chunk_at(c, m.chunk);
        hard_tally_add(&c->row[row_of(&k)], &m.tally);
        done[m.chunk] = 1;
        finished++;
        now++;
        c->done += m.tally.cases;
        if (show) progress_show(&progress, (int)(1000 * finished / chunks), 1000);
        if (!c->state || (progress_now() - saved < 10 && now < goal && now < c->chunks)) continue;
        failed = campaign_save(c, done, chunks, err);
        saved = progress_now();
    }
    progress_end(&progress);
    c->seconds = progress_now() - start;
    if (!failed && now < goal && now < c->chunks)
        return sph_fail(err, "a process ended early: %lu of %lu chunks are done", finished, chunks);
    return failed ? -1 : finished < chunks;
}

/* Starts the processes, gathers, waits. */
static int spread(struct campaign *c, struct shared *shared, uint8_t *done, uint64_t chunks,
                  struct sph_error *err) {
    int ends[2], started = 0, failed = 0;
    pid_t pid[MOST_PROCESSES];
    if (pipe(ends)) return sph_fail(err, "no pipe");
    fflush(NULL);
    for (; started < c->processes && started < MOST_PROCESSES; started++) {
        pid[started] = fork();
        if (pid[started] < 0) break;
        if (pid[started] == 0) {
            close(ends[0]);
            work(c, shared, done, chunks, ends[1]);
        }
    }
    close(ends[1]);
    failed = started ? gather(c, done, chunks, ends[0], err) : sph_fail(err, "no process");
    close(ends[0]);
    for (int i = 0; i < started; i++)
        waitpid(pid[i], NULL, 0);
    return failed;
}

int campaign_run(struct campaign *c, struct sph_error *err) {
    uint64_t chunks = campaign_chunks(c);
    uint8_t *done = calloc(chunks + 1, 1);
    struct shared *shared =
        mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int failed = 0;
    if (!done || shared == MAP_FAILED) {
        free(done);
        return sph_fail(err, "no memory for %lu chunks", chunks);
    }
    if (c->state && campaign_load(c, done, chunks, err) < 0) failed = -1;
    if (!failed && chunks) failed = spread(c, shared, done, chunks, err);
    munmap(shared, sizeof *shared);
    free(done);
    return failed;
}

/* ---- the state file of a campaign: text, one row a line; see campaign.h ---- */
/*   hard-state 2
 *   plan SEED CASES FIRST SHARE FAMILY FAMILIES PROFILE CHUNKS
 *   done 4 chunks a digit, hexadecimal
 *   row ...   counts in the order of struct hard_tally, errors with 17 digits
 *   end */

static const char plan_format[] =
    "plan %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %d %d %d %" PRIu64;

static void plan_of(const struct campaign *c, uint64_t chunks, char *text, size_t size) {
    snprintf(text, size, plan_format, c->seed, c->cases, c->first, c->share, c->family, c->families,
             c->profile, chunks);
}

/* The counts of a tally, in order. */
enum { COUNTS = 6 + HARD_CHECKS + 4 * HARD_COLUMNS };
static void counts_of(struct hard_tally *t, uint64_t *at[COUNTS]) {
    int n = 0;
    uint64_t *head[] = {&t->cases, &t->hits, &t->pairs, &t->naive, &t->points, &t->filtered};
    for (int i = 0; i < 6; i++)
        at[n++] = head[i];
    for (int i = 0; i < HARD_CHECKS; i++)
        at[n++] = &t->wrong[i];
    for (int i = 0; i < HARD_COLUMNS; i++) {
        at[n++] = &t->column[i].hit;
        at[n++] = &t->column[i].root;
        at[n++] = &t->column[i].order;
        at[n++] = &t->column[i].tie;
    }
}

int campaign_save(const struct campaign *c, const uint8_t *done, uint64_t chunks,
                  struct sph_error *err) {
    char plan[256];
    struct sph_output out;
    plan_of(c, chunks, plan, sizeof plan);
    if (sph_output_open(&out, c->state, err)) return -1;
    FILE *f = out.file;
    fprintf(f, "hard-state 2\n%s\ndone ", plan);
    for (uint64_t i = 0; i < chunks; i += 4) {
        int digit = 0;
        for (uint64_t j = i; j < i + 4 && j < chunks; j++)
            digit |= done[j] << (j - i);
        fputc("0123456789abcdef"[digit], f);
    }
    for (int i = 0; i < HARD_ROWS; i++) {
        struct hard_tally t = c->row[i];
        uint64_t *at[COUNTS];
        counts_of(&t, at);
        fprintf(f, "\nrow");
        for (int j = 0; j < COUNTS; j++)
            fprintf(f, " %" PRIu64, *at[j]);
        for (int j = 0; j < HARD_COLUMNS; j++)
            fprintf(f, " %.17g", t.column[j].worst);
        fprintf(f, " %.17g", t.bound);
    }
    fprintf(f, "\nend\n");
    return sph_output_close(&out, 0, err);
}

/* The next word of a row, a number. 0 if it is none. */
static int next_count(char **rest, uint64_t *value) {
    const char *word = strtok_r(NULL, " \n", rest);
    return word && !sph_parse_count(word, 0, UINT64_MAX, value);
}
static int next_real(char **rest, double *value) {
    const char *word = strtok_r(NULL, " \n", rest);
    return word && !sph_parse_number(word, value);
}

/* Reads a row: a line. 0 if anything is missing. */
static int read_row(char *line, struct hard_tally *t) {
    char *rest = line;
    const char *word = strtok_r(NULL, " \n", &rest);
    uint64_t *at[COUNTS];
    counts_of(t, at);
    if (!word || strcmp(word, "row") != 0) return 0;
    for (int j = 0; j < COUNTS; j++)
        if (!next_count(&rest, at[j])) return 0;
    for (int j = 0; j < HARD_COLUMNS; j++)
        if (!next_real(&rest, &t->column[j].worst)) return 0;
    return next_real(&rest, &t->bound) && !strtok_r(NULL, " \n", &rest);
}

/* Reads "done" and the rows. 0 if anything is missing. */
static int read_body(FILE *f, struct campaign *c, uint8_t *done, uint64_t chunks) {
    char *line = NULL;
    size_t room = 0;
    int whole =
        fgetc(f) == 'd' && fgetc(f) == 'o' && fgetc(f) == 'n' && fgetc(f) == 'e' && fgetc(f) == ' ';
    for (uint64_t i = 0; i < chunks && whole; i += 4) {
        int digit = fgetc(f);
        if (digit == EOF || !strchr("0123456789abcdef", digit)) return 0;
        digit = digit <= '9' ? digit - '0' : digit - 'a' + 10;
        for (uint64_t j = i; j < i + 4 && j < chunks; j++)
            done[j] = (uint8_t)(digit >> (j - i) & 1);
    }
    whole = whole && fgetc(f) == '\n';
    for (int i = 0; i < HARD_ROWS && whole; i++)
        whole = getline(&line, &room, f) > 0 && read_row(line, &c->row[i]);
    whole = whole && getline(&line, &room, f) > 0 && !strcmp(line, "end\n");
    free(line);
    return whole;
}

int campaign_load(struct campaign *c, uint8_t *done, uint64_t chunks, struct sph_error *err) {
    char line[256], plan[256];
    FILE *f = fopen(c->state, "r");
    if (!f && errno == ENOENT) return 1;
    if (!f) return sph_fail(err, "%s: %s", c->state, strerror(errno));
    plan_of(c, chunks, plan, sizeof plan);
    if (!fgets(line, sizeof line, f) || strcmp(line, "hard-state 2\n") != 0) {
        fclose(f);
        return sph_fail(err, "%s:1: not a state file of this program", c->state);
    }
    if (!fgets(line, sizeof line, f) || strncmp(line, plan, strlen(plan)) != 0 ||
        line[strlen(plan)] != '\n') {
        fclose(f);
        return sph_fail(err,
                        "%s:2: of another campaign: seed, cases, first, share, family or "
                        "profile differ",
                        c->state);
    }
    int whole = read_body(f, c, done, chunks);
    fclose(f);
    return whole ? 0 : sph_fail(err, "%s: damaged", c->state);
}

/* ---- parts of a campaign that were done apart, put together; see campaign.h ---- */

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
