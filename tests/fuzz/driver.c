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
#include <ctype.h>
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "common/number.h"
#include "common/parallel.h"
#include "fuzz.h"
#include "number.h"

/* ---- inputs made of others, by numbers that a seed decides ---- */

enum { FUZZ_SIZE = 65536 }; /* bytes of the longest input */

struct fuzz_bytes {
    uint8_t *at;
    size_t size;
};

/* Inputs to begin with, and words that the format knows. */
struct fuzz_corpus {
    struct fuzz_bytes *input, *word;
    size_t inputs, words;
};

/* Adds a file, or the files of a folder, to the inputs. Ends the program if it cannot be read. */
void fuzz_add(struct fuzz_corpus *corpus, const char *path);

/* Adds the words of a dictionary of AFL++: lines of name="text", with \xNN, \\ and \". */
void fuzz_add_words(struct fuzz_corpus *corpus, const char *path);

void fuzz_corpus_free(struct fuzz_corpus *corpus);

/* One input of the corpus, changed in one to eight places, to `to` of FUZZ_SIZE bytes; its size. */
size_t fuzz_change(const struct fuzz_corpus *corpus, uint64_t *random, uint8_t *to);

/* ---- change ---- */

enum { CHANGES = 8, PIECE = 64 };

/* Numbers at which things end. */
static const char *const numbers[] = {
    "0",          "-0",      "1",        "-1",      "1e30",  "-1e30",    "1e31",
    "1e-30",      "1e-300",  "nan",      "inf",     "0.5",   "1e308",    "2147483647",
    "4294967296", "16383",   "16384",    "65535",   "180",   "1e-12",    "1e999",
    "0x10",       "1e7",     "16777216", "1048576", "3",     "0.999999", "1e-320",
    "5e-324",     "-1e-310", "1e-17",    "1e17",    "-1e300"};
static const uint32_t binary[] = {0,          1,          0xffffffff, 0x80000000, 0x7fffffff,
                                  0xffff,     0x10000,    0xffffff,   0x1000000,  64,
                                  0x40000000, 0x20000000, 16384,      65536,      0xfffffffe};

static uint32_t draw(uint64_t *random, size_t below) {
    *random ^= *random << 13;
    *random ^= *random >> 7;
    *random ^= *random << 17;
    return (uint32_t)((*random >> 32) % (below ? below : 1));
}

static void *grown(void *array, size_t n, size_t element) {
    if (n & (n - 1)) return array;
    array = realloc(array, (n ? 2 * n : 1) * element);
    if (!array) exit(2);
    return array;
}

static void add(struct fuzz_bytes **list, size_t *n, const uint8_t *bytes, size_t size) {
    *list = grown(*list, *n, sizeof **list);
    struct fuzz_bytes *b = &(*list)[(*n)++];
    *b = (struct fuzz_bytes){malloc(size + 1), size};
    if (!b->at) exit(2);
    memcpy(b->at, bytes, size);
}

static int by_name(const struct dirent **a, const struct dirent **b) {
    return strcmp((*a)->d_name, (*b)->d_name); /* whatever the locale */
}

static int plain(const struct dirent *entry) {
    return entry->d_name[0] != '.';
}

void fuzz_add(struct fuzz_corpus *c, const char *path) {
    static uint8_t bytes[FUZZ_SIZE];
    struct stat about;
    struct dirent **list;
    if (!stat(path, &about) && S_ISDIR(about.st_mode)) {
        int n = scandir(path, &list, plain, by_name);
        for (int i = 0; i < n; i++) {
            char name[4096];
            snprintf(name, sizeof name, "%s/%s", path, list[i]->d_name);
            fuzz_add(c, name);
            free(list[i]);
        }
        if (n >= 0) free(list);
        return;
    }
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(2);
    }
    add(&c->input, &c->inputs, bytes, fread(bytes, 1, sizeof bytes, file));
    fclose(file);
}

void fuzz_add_words(struct fuzz_corpus *c, const char *path) {
    char line[1024];
    FILE *file = fopen(path, "r");
    if (!file) {
        perror(path);
        exit(2);
    }
    while (fgets(line, sizeof line, file)) {
        char *from = strchr(line, '"'), *to = line;
        if (*line == '#' || !from) continue;
        while (*++from && *from != '"') {
            uint64_t byte;
            const char digits[3] = {from[1] == 'x' ? from[2] : 0, from[1] == 'x' ? from[3] : 0, 0};
            if (*from != '\\')
                *to++ = *from;
            else if (!sph_parse_hex(digits, 255, &byte))
                *to++ = (char)byte, from += 3;
            else
                *to++ = *++from;
        }
        add(&c->word, &c->words, (const uint8_t *)line, (size_t)(to - line));
    }
    fclose(file);
}

void fuzz_corpus_free(struct fuzz_corpus *c) {
    for (size_t i = 0; i < c->inputs; i++)
        free(c->input[i].at);
    for (size_t i = 0; i < c->words; i++)
        free(c->word[i].at);
    free(c->input);
    free(c->word);
}

/* Bytes at..at+old become n others; not if there were too many then. */
static size_t put(uint8_t *to, size_t size, size_t at, size_t old, const void *bytes, size_t n) {
    uint8_t copy[FUZZ_SIZE];
    if (size - old + n > FUZZ_SIZE || n > sizeof copy) return size;
    memcpy(copy, bytes, n); /* it may be a part of `to` */
    memmove(to + at + n, to + at + old, size - at - old);
    memcpy(to + at, copy, n);
    return size - old + n;
}

/* The word, up to blanks, at a place: its start; its size in *n. */
static size_t word_at(const uint8_t *to, size_t size, size_t at, size_t *n) {
    size_t end = at;
    while (at && !isspace(to[at - 1]))
        at--;
    while (end < size && !isspace(to[end]))
        end++;
    *n = end - at;
    return at;
}

static size_t change_one(const struct fuzz_corpus *c, uint64_t *random, uint8_t *to, size_t size) {
    size_t at = draw(random, size + 1), left = size - at, n;
    uint8_t byte = (uint8_t)draw(random, 256);
    const char *number = numbers[draw(random, sizeof numbers / sizeof *numbers)];
    uint32_t word = binary[draw(random, sizeof binary / sizeof *binary)];
    const struct fuzz_bytes *other = &c->input[draw(random, c->inputs)];
    switch (draw(random, 11)) {
    case 0:
        if (left) to[at] ^= (uint8_t)(1 << (byte & 7));
        return size;
    case 1:
        if (left) to[at] = byte;
        return size;
    case 2:
        return put(to, size, at, 0, &byte, 1);
    case 3:
        n = draw(random, PIECE);
        return put(to, size, at, n < left ? n : left, "", 0);
    case 4: /* a piece of it once more */
        n = draw(random, PIECE);
        return put(to, size, at, 0, to + at, n < left ? n : left);
    case 5: /* a piece of another */
        n = draw(random, other->size + 1);
        return put(to, size, at, 0, other->at + n,
                   other->size - n < PIECE ? other->size - n : PIECE);
    case 6:
        n = word_at(to, size, at, &left);
        return put(to, size, n, left, number, strlen(number));
    case 7:
        if (!c->words) return size;
        other = &c->word[draw(random, c->words)];
        return put(to, size, at, 0, other->at, other->size);
    case 8:
        if (!c->words) return size;
        other = &c->word[draw(random, c->words)];
        n = word_at(to, size, at, &left);
        return put(to, size, n, left, other->at, other->size);
    case 9:
        at &= ~(size_t)3;
        return size - at >= 4 && size >= at ? put(to, size, at, 4, &word, 4) : size;
    default:
        return draw(random, 4) ? size : at; /* cut off */
    }
}

size_t fuzz_change(const struct fuzz_corpus *c, uint64_t *random, uint8_t *to) {
    const struct fuzz_bytes *from = &c->input[draw(random, c->inputs)];
    size_t size = from->size;
    memcpy(to, from->at, size);
    for (uint32_t left = 1 + draw(random, CHANGES); left; left--)
        size = change_one(c, random, to, size);
    return size;
}

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
