/* driver.c - a harness over a corpus, and over what changes make of it; needs no other program
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: fuzz_NAME [--runs N] [--seconds S] [--seed S] [--dict FILE] [--keep FOLDER]
 *                  --root tests/fuzz FILE|FOLDER...
 *
 * Runs every file as it is, then N changed ones (default 0: none), or as many as S seconds hold.
 * The working folder is FUZZ_TMP. An input that ends the program, or takes more than LONG seconds
 * of a processor or WAIT seconds, is kept as FOLDER/NAME-DIGEST. Prints one line of TAP, with the
 * time of the slowest input. The same seed makes the same inputs.
 *
 * An input of FUZZ_SIZE bytes or less is to be answered within a second. Sanitizers slow the model
 * down about tenfold, so that they have 10 seconds. Processor time counts: of what waits a busy
 * machine makes more.
 */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "common/parallel.h"
#include "change.h"
#include "number.h"
#include "fuzz.h"

#ifdef __SANITIZE_ADDRESS__
int __lsan_do_recoverable_leak_check(void);
const char *__asan_default_options(void);
const char *__ubsan_default_options(void);
/* A report is an abort(). What OpenEXR asks for, up to 2 GiB, would be one: it cannot be refused by
 * an exception here, as it is where memory is limited. */
const char *__asan_default_options(void) {
    return "abort_on_error=1:detect_leaks=1:leak_check_at_exit=0:allocator_may_return_null=1:"
           "max_allocation_size_mb=2560:detect_stack_use_after_return=0";
}
const char *__ubsan_default_options(void) {
    return "abort_on_error=1:print_stacktrace=1";
}
enum { LONG = 10 };
#else
enum { LONG = 1 };
#endif
enum { WAIT = 60 };

struct run {
    const char *name, *keep, *dict, *root;
    unsigned long long runs, seed;
    double seconds;
};

/* What runs at the moment, for the handler of signals. */
static struct fuzz_bytes now;
static char kept[4096];

static void ended(int sign) {
    static const char slow[] = "fuzz: takes too long\n", at[] = "fuzz: input kept as ";
    int file = open(kept, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ssize_t done = sign == SIGALRM || sign == SIGPROF ? write(2, slow, sizeof slow - 1) : 0;
    if (file >= 0) done += write(file, now.at, now.size);
    done += write(2, at, sizeof at - 1) + write(2, kept, strlen(kept)) + write(2, "\n", 1);
    signal(SIGABRT, SIG_DFL);
    if (done) abort();
    _exit(1);
}

static double clock_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double slowest;

static void one(const struct run *run, uint8_t *bytes, size_t size) {
    const struct itimerval limit = {{0, 0}, {LONG, 0}}, none = {{0, 0}, {0, 0}};
    struct itimerval left;
    now = (struct fuzz_bytes){bytes, size};
    snprintf(kept, sizeof kept, "%s/%s-%016llx", run->keep, run->name,
             (unsigned long long)fuzz_hash(bytes, size));
    alarm(WAIT);
    setitimer(ITIMER_PROF, &limit, NULL);
    fuzz_one(bytes, size);
    setitimer(ITIMER_PROF, &none, &left);
    alarm(0);
    double took = LONG - (double)left.it_value.tv_sec - 1e-6 * (double)left.it_value.tv_usec;
    if (took > slowest) slowest = took;
}

static int take_options(int argc, char **argv, struct run *run, struct fuzz_corpus *corpus) {
    const char *keep = ".";
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (!strcmp(argv[i], "--runs"))
            run->runs = test_number(value, argv[i], 0), i++;
        else if (!strcmp(argv[i], "--seconds"))
            run->seconds = (double)test_number(value, argv[i], 0), i++;
        else if (!strcmp(argv[i], "--seed"))
            run->seed = test_number(value, argv[i], 0), i++;
        else if (!strcmp(argv[i], "--dict"))
            fuzz_add_words(corpus, value), i++;
        else if (!strcmp(argv[i], "--keep"))
            keep = value, i++;
        else if (!strcmp(argv[i], "--root"))
            run->root = realpath(value, NULL), i++;
        else
            fuzz_add(corpus, argv[i]);
    }
    run->keep = realpath(keep, NULL);
    return run->root && run->keep && corpus->inputs ? 0 : -1;
}

int main(int argc, char **argv) {
    struct run run = {.seed = 1};
    struct fuzz_corpus corpus = {0};
    static uint8_t bytes[FUZZ_SIZE];
    const char *tmp = getenv("FUZZ_TMP"), *slash = strrchr(argv[0], '/');
    run.name = slash ? slash + 1 : argv[0];
    if (take_options(argc, argv, &run, &corpus) || !tmp || chdir(tmp)) {
        fputs("usage: FUZZ_TMP=FOLDER fuzz_NAME [--runs N] [--seconds S] [--seed S] [--dict FILE] "
              "[--keep FOLDER] --root tests/fuzz FILE|FOLDER...\n",
              stderr);
        return 2;
    }
    if (!SANITIZED) {
        const struct rlimit memory = {1ul << 30, 1ul << 30};
        setrlimit(RLIMIT_DATA, &memory);
    }
    signal(SIGABRT, ended);
    signal(SIGALRM, ended);
    signal(SIGPROF, ended);
    if (!SANITIZED) signal(SIGSEGV, ended);
    sph_parallel_most(1);
    fuzz_begin(run.root);
    double start = clock_now();
    for (size_t i = 0; i < corpus.inputs; i++)
        one(&run, corpus.input[i].at, corpus.input[i].size);
    uint64_t random = (run.seed + 1) * 0x9e3779b97f4a7c15u;
    unsigned long long done = 0;
    while (run.seconds > 0 ? clock_now() - start < run.seconds : done < run.runs) {
        one(&run, bytes, fuzz_change(&corpus, &random, bytes));
        done++;
    }
    printf(
        "ok - %s: %zu inputs as they are, %llu changed with seed %llu, in %.1f s, %.2f s at most\n",
        run.name, corpus.inputs, done, run.seed, clock_now() - start, slowest);
    fuzz_corpus_free(&corpus);
    free((char *)run.keep);
    free((char *)run.root);
#ifdef __SANITIZE_ADDRESS__
    if (__lsan_do_recoverable_leak_check()) return 1;
#endif
    return 0;
}
