/* no_memory.c - preloaded into a program: one of its calls for memory fails
 * SPDX-License-Identifier: Apache-2.0
 *
 * Ways from the project's code to malloc and its like are told apart by who calls them, up to DEPTH
 * callers back, and numbered as they are first met, from 1. NO_MEMORY=N: the N-th way finds no
 * memory when it is met first; N+: nothing does from then on; 0: everything does.
 * NO_MEMORY_WAYS=FILE: the number of ways that were met is added to it as a line at the end of each
 * process.
 */
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DEPTH = 5, OURS = 2, PLACES = 1 << 16 }; /* OURS: frames of this file */

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static uint64_t met[PLACES]; /* hashes of ways, 0: free */
static unsigned ways, wanted;
static int from_then_on, ready;
static _Thread_local int inside;

/* Whether a way was met for the first time. */
static int is_new(uint64_t way) {
    for (unsigned i = 0; i < PLACES; i++) {
        uint64_t *place = &met[(way + i) % PLACES], none = 0;
        if (__atomic_compare_exchange_n(place, &none, way, 0, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST))
            return 1;
        if (none == way) return 0;
    }
    return 0;
}

/* Whether the project calls, itself or through libraries of C: those of C++ end a program. */
static int is_ours(void *const *callers, int n) {
    static const char *const through[] = {"libc.", "libpng", "libz.", "libexpat", "libjansson"};
    Dl_info info;
    for (int i = OURS; i < n; i++) {
        if (!dladdr(callers[i], &info) || !info.dli_fname) return 0;
        const char *slash = strrchr(info.dli_fname, '/'),
                   *name = slash ? slash + 1 : info.dli_fname;
        size_t k = 0;
        if (strstr(name, "sphaera")) return 1;
        while (k < sizeof through / sizeof *through &&
               strncmp(name, through[k], strlen(through[k])))
            k++;
        if (k == sizeof through / sizeof *through) return 0;
    }
    return 0;
}

__attribute__((noinline)) static int fails(void) {
    void *callers[OURS + DEPTH];
    uint64_t way = 14695981039346656037u;
    if (!ready || inside) return 0;
    inside = 1;
    int n = backtrace(callers, OURS + DEPTH);
    for (int i = OURS; i < n; i++)
        way = (way ^ (uintptr_t)callers[i]) * 1099511628211u;
    int new = is_new(way | 1) && is_ours(callers, n);
    inside = 0;
    unsigned now = new ? __atomic_add_fetch(&ways, 1, __ATOMIC_SEQ_CST) : 0;
    int bad = wanted && (now == wanted || (from_then_on && ways >= wanted));
    if (bad) errno = ENOMEM;
    return bad;
}

void *malloc(size_t size) {
    return fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t n, size_t size) {
    return fails() ? NULL : __libc_calloc(n, size);
}

void *realloc(void *old, size_t size) {
    return fails() ? NULL : __libc_realloc(old, size);
}

void *aligned_alloc(size_t alignment, size_t size) {
    return fails() ? NULL : __libc_memalign(alignment, size);
}

__attribute__((constructor)) static void begin(void) {
    const char *way = getenv("NO_MEMORY");
    void *first[1];
    inside = 1;
    backtrace(first, 1); /* loads what it needs */
    inside = 0;
    for (; way && *way >= '0' && *way <= '9'; way++)
        wanted = wanted * 10 + (unsigned)(*way - '0');
    from_then_on = way && *way == '+';
    ready = way != NULL;
}

__attribute__((destructor)) static void end(void) {
    const char *name = getenv("NO_MEMORY_WAYS");
    char line[16];
    int file = name ? open(name, O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
    ready = 0;
    if (file < 0) return;
    int n = snprintf(line, sizeof line, "%u\n", ways);
    if (write(file, line, (size_t)n) != n) _exit(99);
    close(file);
}
