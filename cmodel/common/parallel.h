/* parallel.h - loops and halves of work that threads share
 * SPDX-License-Identifier: Apache-2.0
 *
 * Threads live as long as the call that started them, and wait without turning: between two calls
 * there is none, so a process may fork at any time, and a busy neighbour takes only its own share.
 * They leave signals to the caller's threads and count in the default floating-point environment.
 * Where no thread is to be had, the caller does the work alone. Results never depend on how many
 * there are, as long as parts of the work touch nothing in common or take the lock.
 */
#ifndef SPH_PARALLEL_H
#define SPH_PARALLEL_H

#include <stddef.h>
#include <stdint.h>

/* Processors that this process may run on, at least 1, and no more than OMP_NUM_THREADS of the
 * environment says (the first of its numbers; what is none is passed over). */
int sph_processors(void);

/* At most so many threads, the caller among them, share what this thread calls for from now on; 0:
 * one for every processor. Returns what held before. */
int sph_parallel_most(int threads);

/* The caller alone from now on, if what it is about to do is worth no thread; else nothing changes.
 * Returns what sph_parallel_most() would. */
int sph_parallel_if(int worth);

/* Calls part(user, first, end) for ranges that make up 0..n-1, in no order. grain: items that are
 * worth a thread; fewer than two grains are left to the caller. */
void sph_parallel_for(uint32_t n, uint32_t grain,
                      void (*part)(void *user, uint32_t first, uint32_t end), void *user);

/* Calls half(a) and half(b), the first by another thread if that is worth one and there is one. */
void sph_parallel_two(int worth, void (*half)(void *), void *a, void *b);

/* One thread at a time of those that share the work at hand; parts of a call that nobody shares
 * need no lock and take none. */
void sph_parallel_lock(void);
void sph_parallel_unlock(void);

/* ---- how far long work is, told to who asked ---- */

/* What is told, or a part of it: that between two shares of all, 0..1. */
struct sph_progress {
    /* NULL: nobody asked; of one thread at a time. Not 0: the work is not wanted any more, its
     * result is thrown away. */
    int (*show)(void *user, int done, int all);
    void *user;
    double from, to;
};

enum { SPH_PROGRESS_ALL = 1000 };

/* Tells that a share, 0..1, of the part is done; p may be NULL. What show() says: not 0: end. */
static inline int sph_progress_at(const struct sph_progress *p, double share) {
    if (!p || !p->show) return 0;
    double done = p->from + (p->to - p->from) * share;
    sph_parallel_lock();
    int end = p->show(p->user, (int)(SPH_PROGRESS_ALL * done), SPH_PROGRESS_ALL);
    sph_parallel_unlock();
    return end;
}

/* The part of a part between two shares of it; p may be NULL. */
static inline struct sph_progress sph_progress_part(const struct sph_progress *p, double from,
                                                    double to) {
    if (!p) return (struct sph_progress){NULL, NULL, 0, 1};
    double size = p->to - p->from;
    return (struct sph_progress){p->show, p->user, p->from + size * from, p->from + size * to};
}

#endif
