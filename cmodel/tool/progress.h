/* progress.h - how far long work is, on a terminal only
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_PROGRESS_H
#define SPH_TOOL_PROGRESS_H

#include "common/parallel.h"

struct progress {
    const char *what;
    int shown;          /* something stands on the line */
    double start, last; /* seconds */
};

/* Starts; 1 if progress is to be shown: stderr is a terminal, or forced. */
int progress_start(struct progress *p, const char *what, int forced);

/* The same for work that tells it; show is NULL if progress is not to be shown. */
struct sph_progress progress_of(struct progress *p, const char *what, int forced);

/* Shows done of all in percent, at most ten times a second, not in the first half second. Fits
 * sph_render_options.progress; always 0. */
int progress_show(void *p, int done, int all);

/* Clears the line. */
void progress_end(struct progress *p);

/* Seconds of a clock that never goes back. */
double progress_now(void);

#endif
