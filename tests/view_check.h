/* view_check.h - the exact predicate, for the tests of background separation
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_VIEW_CHECK_H
#define SPH_TEST_VIEW_CHECK_H

#include "build_scene.h"

/* Random views of a test; the sanitizers slow them down. */
#ifdef __SANITIZE_ADDRESS__
enum { VIEWS = 200 };
#else
enum { VIEWS = 4000 };
#endif

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

#endif
