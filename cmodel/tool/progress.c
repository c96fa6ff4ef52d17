/* progress.c - see progress.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

double progress_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int progress_start(struct progress *p, const char *what, int forced) {
    double now = progress_now();
    *p = (struct progress){what, 0, now, forced ? 0 : now + 0.4};
    return forced || isatty(STDERR_FILENO);
}

struct sph_progress progress_of(struct progress *p, const char *what, int forced) {
    int shown = progress_start(p, what, forced);
    return (struct sph_progress){shown ? progress_show : NULL, p, 0, 1};
}

int progress_show(void *user, int done, int all) {
    struct progress *p = user;
    double now = progress_now();
    if (now - p->last < 0.1) return 0;
    p->last = now;
    p->shown = 1;
    fprintf(stderr, "\r  %s %3d %%", p->what, (int)(100.0 * done / all));
    return 0;
}

void progress_end(struct progress *p) {
    if (p->shown) fprintf(stderr, "\r\033[K");
    p->shown = 0;
}
