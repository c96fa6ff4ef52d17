/* view_check.h - the exact predicate and random spheres, for the tests of background separation
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_VIEW_CHECK_H
#define SPH_TEST_VIEW_CHECK_H

#include "build_scene.h"

#include <math.h>

#include "builder/grid/grid.h"

/* Random views of a test; the sanitizers slow them down. */
enum { VIEWS = SANITIZED ? 200 : 4000 };

/* Exact, from the definition: does the ray from eye along dir meet the inside of the ball ahead? */
static inline int hits(const int32_t eye[3], const int64_t dir[3], const struct sph_ball *ball) {
    __int128 a = 0, b = 0, k = (__int128)ball->r * ball->r;
    for (int i = 0; i < 3; i++) {
        int64_t oc = (int64_t)ball->c[i] - eye[i];
        a += (__int128)dir[i] * dir[i];
        b += (__int128)oc * dir[i];
        k -= (__int128)oc * oc;
    }
    return k * a + b * b > 0 && (b > 0 || k > 0);
}

/* Random sphere, eye and rays over the whole range of a profile. */
static inline void random_sphere(const struct sph_profile *p, int width, int height,
                                 struct sph_ball *ball, int32_t eye[3], struct sph_rays *rays) {
    double room = ldexp(1, p->w - 1);
    struct sph_raster raster = {width, height, 0, {0, 0}};
    do {
        raster.angle = between(0.5, 170);
        for (int i = 0; i < 2; i++)
            raster.shift[i] = uniform() < 0.5 ? 0 : between(-1, 1);
    } while (sph_rays_fit(&raster, p->wd, rays, NULL));
    for (int i = 0; i < 3; i++) {
        eye[i] = (int32_t)between(-room, room);
        ball->c[i] = (int32_t)between(-room, room);
        if (uniform() < 0.2) eye[i] = uniform() < 0.5 ? (int32_t)room - 1 : -(int32_t)room;
        if (uniform() < 0.2) ball->c[i] = uniform() < 0.5 ? (int32_t)room - 1 : -(int32_t)room;
    }
    ball->r = (int32_t)(1 + 1.7 * room * pow(uniform(), 4));
}

#endif
