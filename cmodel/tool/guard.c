/* guard.c - see guard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/guard.h"

#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "common/number.h"
#include "common/file.h"
#include "common/parallel.h"

static unsigned long long memory; /* bytes; 0: as many as there are */

/* Waits for one of the signals, which every other thread leaves to this one. */
static void *wait_for(void *set) {
    int number = 0;
    if (sigwait(set, &number)) return NULL;
    sph_output_clean();
    dprintf(STDERR_FILENO, "sphaera: ended by signal %d, %s\n", number, sigdescr_np(number));
    signal(number, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, set, NULL);
    raise(number);
    return NULL;
}

static void watch_signals(void) {
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    static sigset_t set;
    struct sigaction now;
    pthread_t thread;
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    sigemptyset(&set);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (!sigaction(numbers[i], NULL, &now) && now.sa_handler != SIG_IGN)
            sigaddset(&set, numbers[i]);
    pthread_sigmask(SIG_BLOCK, &set, NULL);
    if (pthread_create(&thread, NULL, wait_for, &set))
        pthread_sigmask(SIG_UNBLOCK, &set, NULL);
    else
        pthread_detach(thread);
}

/* Bytes that a text says; 0 for `unlimited`; -1 if it says none. */
static long long bytes_of(const char *text) {
    static const char units[] = "KMG";
    const char *end = text;
    uint64_t n;
    if (!strcmp(text, "unlimited")) return 0;
    if (sph_take_count(&end, 1, 1ull << 61, &n)) return -1;
    const char *unit = *end ? strchr(units, *end) : NULL;
    int shift = unit ? 10 * (int)(unit - units + 1) : 0;
    int good = n < 1ull << (62 - shift) && (unit ? !end[1] : !*end);
    return good ? (long long)(n << shift) : -1;
}

/* Of stacks, which count as data too: of each thread of a loop, and of libraries as many again. */
static unsigned long long stacks(void) {
    struct rlimit stack;
    unsigned long long one = 8ull << 20;
    if (!getrlimit(RLIMIT_STACK, &stack) && stack.rlim_cur != RLIM_INFINITY) one = stack.rlim_cur;
    return 2 * one * (unsigned)(sph_processors() + 1);
}

int guard_start(void) {
    const char *asked = getenv("SPHAERA_MEMORY");
    long long bytes = asked ? bytes_of(asked) : (long long)GUARD_MEMORY;
    struct rlimit limit;
    if (bytes < 0) {
        fprintf(stderr, "sphaera: SPHAERA_MEMORY: '%.80s' is no number of bytes such as 2G\n",
                asked);
        return -1;
    }
    memory = (unsigned long long)bytes;
    if (memory && !getrlimit(RLIMIT_DATA, &limit)) {
        rlim_t most = memory + stacks();
        if (limit.rlim_cur == RLIM_INFINITY || most < limit.rlim_cur) {
            limit.rlim_cur = most;
            setrlimit(RLIMIT_DATA, &limit);
        }
    }
    watch_signals();
    return 0;
}

void guard_say_memory(void) {
    if (memory)
        fprintf(stderr, "sphaera: memory is limited to %llu MiB; SPHAERA_MEMORY=4G allows more\n",
                memory >> 20);
}
