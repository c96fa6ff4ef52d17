/* progress.h - how far long work is, told to who asked
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PROGRESS_H
#define SPH_PROGRESS_H

#include "common/parallel.h"

#include <stddef.h>

/* What is told, or a part of it: that between two shares of all, 0..1. */
struct sph_progress {
    void (*show)(void *user, int done, int all); /* NULL: nobody asked; of one thread at a time */
    void *user;
    double from, to;
};

enum { SPH_PROGRESS_ALL = 1000 };

/* Tells that a share, 0..1, of the part is done; p may be NULL. */
static inline void sph_progress_at(const struct sph_progress *p, double share) {
    if (!p || !p->show) return;
    double done = p->from + (p->to - p->from) * share;
    sph_parallel_lock();
    p->show(p->user, (int)(SPH_PROGRESS_ALL * done), SPH_PROGRESS_ALL);
    sph_parallel_unlock();
}

/* The part of a part between two shares of it; p may be NULL. */
static inline struct sph_progress sph_progress_part(const struct sph_progress *p, double from,
                                                    double to) {
    if (!p) return (struct sph_progress){NULL, NULL, 0, 1};
    double size = p->to - p->from;
    return (struct sph_progress){p->show, p->user, p->from + size * from, p->from + size * to};
}

#endif
