/* sample.c - see sample.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/tree/sample.h"

#include "engine/render_pixel.h"
#include "fast/fast.h"

/* Parts of the frame at most, and how far their middles lie apart at least. */
enum { COLUMNS = 32, ROWS = 18, APART = 4 };

static int parts(int side, int most) {
    int n = (side + APART - 1) / APART;
    return n < most ? n : most;
}

int sph_sample(const struct sph_machine *m, sph_sample_look *look, void *user,
               struct sph_error *err) {
    int width = m->regs[SPH_REG_FRAME_W], height = m->regs[SPH_REG_FRAME_H], full = 0;
    struct sph_fast *fast = sph_fast_new(m, SPH_FAST_BEST); /* or NULL */
    int columns = parts(width, COLUMNS), rows = parts(height, ROWS);
#pragma omp parallel for schedule(dynamic, 1) reduction(| : full)
    for (int i = 0; i < columns * rows; i++) {
        struct sph_ray_log log = {0};
        struct sph_render_options o = {
            .traverse = fast ? SPH_TRAVERSE_FAST : SPH_TRAVERSE_TREE, .fast = fast, .log = &log};
        struct sph_counters counters = {{0}};
        uint32_t errors = 0;
        sph_render_pixel(m, &o, (2 * (i % columns) + 1) * width / (2 * columns),
                         (2 * (i / columns) + 1) * height / (2 * rows), &counters, &errors, NULL);
        for (int j = 0; j < log.n; j++)
            look(user, &log.rays[j]);
        full |= log.full;
        sph_ray_log_free(&log);
    }
    sph_fast_free(fast);
    return full ? sph_fail(err, "out of memory for a sample of rays") : 0;
}
