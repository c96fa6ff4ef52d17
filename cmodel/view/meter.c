/* meter.c - see meter.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/meter.h"

#include <inttypes.h>
#include <math.h>
#include <time.h>

double view_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void view_meter_input(struct view_meter *m, double time, uint64_t camera_changes) {
    m->last_input = time;
    if (m->n == VIEW_WAITING) return;
    m->waiting[m->n].time = time;
    m->waiting[m->n++].camera_changes = camera_changes;
}

void view_meter_shown(struct view_meter *m, double time, uint64_t camera_changes) {
    int kept = 0;
    for (int i = 0; i < m->n; i++) {
        double took = time - m->waiting[i].time;
        if (m->waiting[i].camera_changes > camera_changes) {
            m->waiting[kept++] = m->waiting[i];
            continue;
        }
        m->answers++;
        m->late += took > VIEW_SOON;
        m->sum += took;
        m->worst = fmax(m->worst, took);
    }
    m->n = kept;
    if (time - m->last_input < VIEW_STILL && m->last_input > 0) {
        if (time - m->last_picture < VIEW_STILL) {
            m->pictures++;
            m->moving += time - m->last_picture;
        }
        m->last_picture = time;
    }
}

void view_meter_print(const struct view_meter *m, FILE *to) {
    fprintf(to, "answers  %" PRIu64 " to inputs", m->answers);
    if (m->answers)
        fprintf(to, ", mean %.1f ms, longest %.1f ms, %" PRIu64 " above %.0f ms",
                1000 * m->sum / (double)m->answers, 1000 * m->worst, m->late, 1000 * VIEW_SOON);
    if (m->moving > 0)
        fprintf(to, "\nmoving   %.1f pictures a second over %.2f s",
                (double)m->pictures / m->moving, m->moving);
    putc('\n', to);
    fflush(to);
}
