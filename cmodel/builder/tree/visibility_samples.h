/* visibility_samples.h - rays of a frame, each as far as its own hit, and what they meet
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VISIBILITY_SAMPLES_H
#define SPH_VISIBILITY_SAMPLES_H

#include "common/error.h"
#include "core/ray_log.h"
#include "machine/machine.h"
#include "trace/bih.h"
#include "trace/filter.h"

struct sph_visibility_sample { /* a ray on its way to what it hit */
    struct sph_ray ray;
    struct sph_bih_ray planes; /* in a tree of boxes */
    int32_t depth_max;
    uint32_t weight; /* what it counts for */
};

struct sph_visibility_samples {
    struct sph_visibility_sample *rays;
    uint32_t n;
};

/* The rays of a sample of the machine's frame, in any order; boxes: for a tree of boxes. A shadow
 * ray that is blocked ends somewhere on its way: it counts for a third of any other. -1 if memory
 * is out; what is there is to be freed. */
int sph_visibility_samples(const struct sph_machine *machine, int boxes,
                           struct sph_visibility_samples *samples, struct sph_error *err);

void sph_visibility_samples_free(struct sph_visibility_samples *samples);

/* As the box of a child is met, but for what a node's frame rounds. */
static inline int sph_visibility_sample_meets_box(const struct sph_visibility_sample *s,
                                                  const struct sph_box *box) {
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    for (int i = 0; i < 3; i++)
        if (!sph_bih_cut(&s->planes, &s->ray, i, box->lo[i], 0, &span) ||
            !sph_bih_cut(&s->planes, &s->ray, i, box->hi[i], 1, &span))
            return 0;
    return span.lo <= span.hi && sph_box_depth(span.lo) <= s->depth_max;
}

static inline int sph_visibility_sample_meets_ball(const struct sph_visibility_sample *s,
                                                   const struct sph_child *ball) {
    int32_t near;
    return sph_filter(&s->ray, ball, s->depth_max, &near);
}

/* What is done with a ray of the sample and what it found; of several threads at a time. */
typedef void sph_sample_look(void *user, const struct sph_logged *ray);

/* Traces the rays of the pixels in the middles of at most 32 x 18 equal parts of the machine's
 * frame. Which rays there are does not depend on its tree. -1 if memory is out. */
int sph_sample(const struct sph_machine *machine, sph_sample_look *look, void *user,
               struct sph_error *err);

#endif
