/* rays.c - integer directions of primary rays; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * With an even pitch p the pixel centres (x - (width-1)/2) * p are integers, so that
 * dir = (x0 + x*p, y0 - y*p, -d) carries no rounding; only tan(angle/2) = p*height/2 / d does.
 */
#include <math.h>

#include "builder/grid/grid.h"
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

/* Components along axis i of the grid of the camera's axes. */
static void along(const struct sph_grid *grid, int i, double to[3]) {
    const double *row = grid->rotation + 3 * (size_t)i;
    for (int k = 0; k < 3; k++) {
        const double *axis = grid->camera + 3 * (size_t)k;
        to[k] = row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2];
    }
}

/* The longest component at a corner of the raster, and so anywhere. */
static double longest(const struct sph_rays *rays, int width, int height,
                      const struct sph_grid *grid) {
    double most = 0, to[3];
    for (int corner = 0; corner < 4; corner++)
        for (int i = 0; i < 3; i++) {
            double x = rays->x0 + (corner & 1 ? (width - 1.0) * rays->pitch : 0);
            double y = rays->y0 - (corner & 2 ? (height - 1.0) * rays->pitch : 0);
            along(grid, i, to);
            most = fmax(most, fabs(to[0] * x + to[1] * y + to[2] * rays->z));
        }
    return most;
}

int sph_rays_turn(const struct sph_rays *rays, int width, int height, const struct sph_grid *grid,
                  const struct sph_profile *profile, struct sph_steps *steps,
                  struct sph_error *err) {
    int fraction = 32 - profile->wd;
    double room = ldexp(1, profile->wd - 1) - 3 - ldexp(width + height, -fraction); /* roundings */
    double scale = room / longest(rays, width, height, grid), to[3];
    double far = floor(-rays->z * scale) - 1;
    if (!(far >= (double)sph_min_screen(profile)))
        return sph_fail(err,
                        "along the scene's axes the screen is %.0f away, %d bits of the "
                        "quotient need %lld",
                        far, profile->pq, (long long)sph_min_screen(profile));
    scale = ldexp(scale, fraction);
    steps->off = sqrt(3) / (rays->pitch * scale); /* sqrt(3)/2 of either */
    for (int i = 0; i < 3; i++) {
        along(grid, i, to);
        steps->across[i] = (int32_t)lround(to[0] * rays->pitch * scale);
        steps->down[i] = (int32_t)lround(-to[1] * rays->pitch * scale);
        double middle = to[2] * rays->z * scale; /* where no step's rounding counts */
        steps->first[i] = (int32_t)lround(middle - (double)steps->across[i] * (width - 1) / 2 -
                                          (double)steps->down[i] * (height - 1) / 2) +
                          (1 << (fraction - 1)); /* half a unit: to nearest */
    }
    return 0;
}
