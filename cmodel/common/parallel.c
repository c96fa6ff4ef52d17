/* parallel.c - see parallel.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/parallel.h"

#include <fenv.h>
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "common/number.h"

enum { PARTS = 16 }; /* of a grain: what a thread takes at a time */

/* Those that share the work of one outermost call. */
struct team {
    atomic_int spare; /* threads that may still be started */
    pthread_mutex_t lock;
};

static _Thread_local struct team *team; /* that this thread works for; NULL: for itself */
static _Thread_local int most;          /* threads of a team; 0: as many as processors */

/* A thread's work. */
struct helper {
    pthread_t thread;
    struct team *team;
    void (*work)(void *);
    void *user;
};

struct loop {
    atomic_ullong next; /* item that nobody has taken */
    uint32_t n, chunk;
    void (*part)(void *, uint32_t, uint32_t);
    void *user;
};

int sph_processors(void) {
    cpu_set_t set;
    uint64_t asked;
    const char *threads = getenv("OMP_NUM_THREADS");
    int n = sched_getaffinity(0, sizeof set, &set) ? 0 : CPU_COUNT(&set);
    if (threads && !sph_take_count(&threads, 1, INT_MAX, &asked) &&
        (!*threads || *threads == ',') && (int)asked < n)
        n = (int)asked;
    return n > 1 ? n : 1;
}

int sph_parallel_most(int threads) {
    int before = most;
    most = threads;
    return before;
}

int sph_parallel_if(int worth) {
    return sph_parallel_most(worth ? most : 1);
}

static void *begin(void *user) {
    struct helper *helper = user;
    fesetenv(FE_DFL_ENV);
    team = helper->team;
    helper->work(helper->user);
    atomic_fetch_add(&team->spare, 1);
    return NULL;
}

/* Starts a thread of the team; 0 if it has none to spare. */
static int start(struct helper *helper) {
    sigset_t all, before;
    int spare = atomic_load(&helper->team->spare);
    while (spare > 0 && !atomic_compare_exchange_weak(&helper->team->spare, &spare, spare - 1))
        ;
    if (spare <= 0) return 0;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    int rc = pthread_create(&helper->thread, NULL, begin, helper);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (rc) atomic_fetch_add(&helper->team->spare, 1);
    return !rc;
}

/* The team of this thread, or its own from now on, which team_end() gives up. */
static struct team *team_begin(struct team *own) {
    if (team) return team;
    atomic_init(&own->spare, (most > 0 ? most : sph_processors()) - 1);
    pthread_mutex_init(&own->lock, NULL);
    return team = own;
}

static void team_end(struct team *own) {
    if (team != own) return;
    team = NULL;
    pthread_mutex_destroy(&own->lock);
}

static void work(void *user) {
    struct loop *loop = user;
    uint64_t first;
    while ((first = atomic_fetch_add(&loop->next, loop->chunk)) < loop->n) {
        uint64_t end = first + loop->chunk;
        loop->part(loop->user, (uint32_t)first, end < loop->n ? (uint32_t)end : loop->n);
    }
}

/* Shares a loop with as many threads as it is worth and there are: each starts the next one. */
struct chain {
    struct loop *loop;
    uint32_t worth;
};

static void chain(void *user) {
    struct chain *c = user;
    struct chain rest = {c->loop, c->worth - 1};
    struct helper next = {.team = team, .work = chain, .user = &rest};
    int started = c->worth > 1 && start(&next);
    work(c->loop);
    if (started) pthread_join(next.thread, NULL);
}

void sph_parallel_for(uint32_t n, uint32_t grain,
                      void (*part)(void *user, uint32_t first, uint32_t end), void *user) {
    struct team own;
    struct loop loop = {.n = n, .chunk = grain / PARTS ? grain / PARTS : 1, .part = part, user};
    struct chain all = {&loop, n / grain};
    if (n / grain < 2) {
        if (n) part(user, 0, n);
        return;
    }
    team_begin(&own);
    chain(&all);
    team_end(&own);
}

void sph_parallel_two(int worth, void (*half)(void *), void *a, void *b) {
    struct team own;
    if (!worth) {
        half(a);
        half(b);
        return;
    }
    struct helper other = {.team = team_begin(&own), .work = half, .user = a};
    int started = start(&other);
    if (!started) half(a);
    half(b);
    if (started) pthread_join(other.thread, NULL);
    team_end(&own);
}

void sph_parallel_lock(void) {
    if (team) pthread_mutex_lock(&team->lock);
}

void sph_parallel_unlock(void) {
    if (team) pthread_mutex_unlock(&team->lock);
}
