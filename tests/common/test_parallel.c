/* test_parallel.c - shared loops and halves: all of the work, once; threads that leave nothing
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/parallel.h"

/* clang-format off: cmocka.h needs these before it */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
/* clang-format on */
#include <dirent.h>
#include <fenv.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST = 70000 };

static uint8_t times[MOST];
static int calls;

static void count(void *user, uint32_t first, uint32_t end) {
    (void)user;
    __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
    for (uint32_t i = first; i < end; i++)
        times[i]++;
}

/* Threads of this process. */
static int threads(void) {
    DIR *tasks = opendir("/proc/self/task");
    int n = -2; /* . and .. */
    while (readdir(tasks))
        n++;
    closedir(tasks);
    return n;
}

/* Each item once, whatever the threads and the grain; afterwards there is one thread. */
static void loops(void **unused) {
    static const uint32_t sizes[] = {0, 1, 2, 15, 16, 17, 1023, 4096, 65537, MOST};
    static const uint32_t grains[] = {1, 2, 16, 1000, 8192};
    (void)unused;
    int before = threads();
    for (int most = 0; most < 9; most++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
            for (size_t g = 0; g < sizeof grains / sizeof *grains; g++) {
                uint32_t n = sizes[i] / grains[g] > 4096 ? 4096 * grains[g] : sizes[i];
                int was = sph_parallel_most(most);
                for (uint32_t k = 0; k < MOST; k++)
                    times[k] = 0;
                calls = 0;
                sph_parallel_for(n, grains[g], count, NULL);
                for (uint32_t k = 0; k < MOST; k++)
                    assert_int_equal(times[k], k < n);
                if (n && n / grains[g] < 2) assert_int_equal(calls, 1);
                assert_int_equal(sph_parallel_most(was), most);
                for (int ms = 0; threads() != before && ms < 5000; ms++)
                    usleep(1000); /* one that was joined is listed a moment longer */
                assert_int_equal(threads(), before);
            }
}

struct node {
    int depth;
    uint64_t leaves;
};

static void grow(void *user) {
    struct node *node = user;
    struct node left = {node->depth - 1, 0}, right = {node->depth - 1, 0};
    if (!node->depth) {
        node->leaves = 1;
        return;
    }
    sph_parallel_two(node->depth > 4, grow, &left, &right);
    node->leaves = left.leaves + right.leaves;
}

/* Halves of halves, below loops too. */
static void trees(void *user, uint32_t first, uint32_t end) {
    uint64_t *sum = user;
    for (; first < end; first++) {
        struct node root = {10, 0};
        grow(&root);
        sph_parallel_lock();
        *sum += root.leaves;
        sph_parallel_unlock();
    }
}

static void halves(void **unused) {
    (void)unused;
    for (int most = 1; most < 9; most++) {
        uint64_t sum = 0;
        sph_parallel_most(most);
        sph_parallel_for(32, 1, trees, &sum);
        assert_int_equal(sum, 32 << 10);
    }
    sph_parallel_most(0);
}

struct seen {
    pthread_t caller;
    int others, signals, rounds, least, alive;
};

/* What is so in threads that are not the caller's. All wait for each other, so there are some. */
static void look(void *user, uint32_t first, uint32_t end) {
    struct seen *s = user;
    sigset_t blocked;
    (void)first, (void)end;
    __atomic_add_fetch(&s->alive, 1, __ATOMIC_SEQ_CST);
    while (__atomic_load_n(&s->alive, __ATOMIC_SEQ_CST) < s->least)
        sched_yield();
    if (pthread_equal(pthread_self(), s->caller)) return;
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    sph_parallel_lock();
    s->others++;
    s->signals += !sigismember(&blocked, SIGINT) || !sigismember(&blocked, SIGALRM);
    s->rounds += fegetround() != FE_TONEAREST;
    sph_parallel_unlock();
}

/* They take no signals and round to nearest, and the caller's own stay. */
static void environment(void **unused) {
    (void)unused;
    struct seen seen = {.caller = pthread_self(), .least = 4};
    sigset_t blocked;
    fesetround(FE_DOWNWARD);
    sph_parallel_most(4);
    sph_parallel_for(4, 1, look, &seen);
    sph_parallel_most(0);
    int round = fegetround();
    fesetround(FE_TONEAREST);
    assert_int_equal(round, FE_DOWNWARD);
    assert_int_equal(seen.others, 3);
    assert_int_equal(seen.signals, 0);
    assert_int_equal(seen.rounds, 0);
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    assert_false(sigismember(&blocked, SIGINT));
}

static void *share(void *user) {
    sph_parallel_most(3);
    sph_parallel_for(3, 1, look, user);
    return NULL;
}

/* A process forks while another thread shares work; the child may share its own. */
static void forks(void **unused) {
    (void)unused;
    struct seen seen = {.least = 4}; /* three of them and this thread */
    pthread_t other;
    int status;
    assert_int_equal(pthread_create(&other, NULL, share, &seen), 0);
    while (__atomic_load_n(&seen.alive, __ATOMIC_SEQ_CST) < 3)
        sched_yield();
    pid_t child = fork();
    if (!child) {
        uint64_t sum = 0;
        alarm(20);
        sph_parallel_most(4);
        sph_parallel_for(32, 1, trees, &sum);
        _exit(sum != 32 << 10);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    __atomic_add_fetch(&seen.alive, 1, __ATOMIC_SEQ_CST);
    pthread_join(other, NULL);
    assert_int_equal(status, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(loops), cmocka_unit_test(halves),
                                       cmocka_unit_test(environment), cmocka_unit_test(forks)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
