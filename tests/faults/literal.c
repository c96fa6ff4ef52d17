/* literal.c - sph_render() by the stages as they are written, not by the copy made for speed
 * SPDX-License-Identifier: Apache-2.0
 *
 * Linked with --wrap=sph_render, so that a fault put into one file of the stages is drawn.
 */
#include "render/render.h"

int __real_sph_render(const struct sph_machine *m, const struct sph_render_options *options,
                      struct sph_frame *frame, struct sph_counters *counters,
                      struct sph_error *err);
int __wrap_sph_render(const struct sph_machine *m, const struct sph_render_options *options,
                      struct sph_frame *frame, struct sph_counters *counters,
                      struct sph_error *err);

int __wrap_sph_render(const struct sph_machine *m, const struct sph_render_options *options,
                      struct sph_frame *frame, struct sph_counters *counters,
                      struct sph_error *err) {
    struct sph_render_options literally = *options;
    literally.traverse = SPH_TRAVERSE_TREE;
    return __real_sph_render(m, &literally, frame, counters, err);
}
