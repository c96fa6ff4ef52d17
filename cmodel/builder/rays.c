/* rays.c - integer directions of primary rays; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * With an even pitch p the pixel centres (x - (width-1)/2) * p are integers, so that
 * dir = (x0 + x*p, y0 - y*p, -d) carries no rounding; only tan(angle/2) = p*height/2 / d does.
 */
#include <math.h>

#include "builder/grid.h"
#include "machine/layout.h"

/* The screen distance for a pitch; its relative error of tan(angle/2), infinite if too short. */
static double screen(int height, double tangent, int64_t pitch, int64_t *d) {
    double half = (double)pitch * height / 2;
    *d = llround(fmin(half / tangent, 1e15));
    if (*d < SPH_MIN_SCREEN) return INFINITY;
    return fabs(half / (double)*d / tangent - 1);
}

int sph_rays_fit(int width, int height, double angle, int wd, struct sph_rays *rays,
                 struct sph_error *err) {
    int64_t most = (1ll << (wd - 1)) - 1, side = width > height ? width : height, d;
    if (!(angle > 0 && angle < 180))
        return sph_fail(err, "angle %g is not between 0 and 180 degrees", angle);
    double tangent = tan(angle * 3.14159265358979323846 / 360);

    int64_t top = side > 1 ? 2 * most / (side - 1) : 2 * most;
    double by_distance = ((double)most + 0.5) * 2 * tangent / height;
    if (by_distance < (double)top) top = (int64_t)by_distance;
    for (top &= ~1ll; top >= 2; top -= 2) {
        screen(height, tangent, top, &d);
        if (d <= most) break;
    }
    if (top < 2)
        return sph_fail(
            err,
            "a raster of %dx%d at angle %g needs finer pixels than %d bits of direction "
            "can tell apart: choose fewer pixels",
            width, height, angle, wd);

    double least = INFINITY;
    int64_t pitch = 0;
    for (int64_t p = top; p >= 2 && 8 * p >= 7 * top; p -= 2) {
        double error = screen(height, tangent, p, &d);
        if (error < least) least = error, pitch = p;
    }
    if (!pitch) return sph_fail(err, "angle %g is too wide for %d bits of direction", angle, wd);
    screen(height, tangent, pitch, &d);
    rays->pitch = (int32_t)pitch;
    rays->x0 = (int32_t)(-(width - 1) * pitch / 2);
    rays->y0 = (int32_t)((height - 1) * pitch / 2);
    rays->z = (int32_t)-d;
    rays->fov_error = least;
    return 0;
}

/* The same for all that a profile asks of a camera. */
static int fits(int width, int height, double angle, const struct sph_profile *p,
                struct sph_rays *rays, struct sph_error *err) {
    if (sph_rays_fit(width, height, angle, p->wd, rays, err)) return -1;
    if (-(int64_t)rays->z >= sph_min_screen(p)) return 0;
    return sph_fail(err, "angle %g puts the screen %d away, %d bits of the quotient need %lld",
                    angle, -rays->z, p->pq, (long long)sph_min_screen(p));
}

int sph_rays_of(int width, int height, double angle, const struct sph_profile *profile,
                struct sph_rays *rays, struct sph_error *err) {
    struct sph_error why = {{0}};
    if (!fits(width, height, angle, profile, rays, &why)) return 0;
    for (int p = 0; p < SPH_PROFILES; p++)
        if (sph_profiles[p].wd > profile->wd &&
            !fits(width, height, angle, &sph_profiles[p], rays, NULL))
            return sph_fail(err, "%.400s; profile %s would do", why.text, sph_profiles[p].name);
    return sph_fail(err, "%.400s; no finer profile would do", why.text);
}
