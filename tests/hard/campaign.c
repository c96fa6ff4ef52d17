/* campaign.c - see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "campaign.h"

#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

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
