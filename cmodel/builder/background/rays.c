/* rays.c - integer directions of primary rays; see grid.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * With an even pitch p the pixel centres (x - (width-1)/2) * p are integers, so that
 * dir = (x0 + x*p, y0 - y*p, -d) carries no rounding; only tan(angle/2) = p*height/2 / d does, and
 * the shift of a picture, which is rounded to a whole direction unit, 1/p of a pixel.
 */
#include <math.h>

#include "builder/grid/grid.h"
#include "machine/layout.h"
#include "scene/window.h"

/* The screen distance for a pitch; its relative error of tan(angle/2), infinite if too short. */
static double screen(int height, double tangent, int64_t pitch, int64_t *d) {
    double half = (double)pitch * height / 2;
    *d = llround(fmin(half / tangent, 1e15));
    if (*d < SPH_MIN_SCREEN) return INFINITY;
    return fabs(half / (double)*d / tangent - 1);
}

struct sph_raster sph_raster_of(const struct sph_camera *camera, int width, int height,
                                double angle) {
    return (struct sph_raster){width * sph_wall_columns(camera),
                               height * sph_wall_rows(camera),
                               angle,
                               {camera->shift[0], camera->shift[1]}};
}

/* Pitches of the longest way from the view's axis to the middle of a pixel, by an axis. */
static double farthest(const struct sph_raster *r) {
    double across = (r->width - 1) / 2.0 + fabs(r->shift[0]) * r->height;
    double down = (r->height - 1) / 2.0 + fabs(r->shift[1]) * r->height;
    return fmax(across, down);
}

int sph_rays_fit(const struct sph_raster *raster, int wd, struct sph_rays *rays,
                 struct sph_error *err) {
    const int width = raster->width, height = raster->height;
    const double angle = raster->angle, *shift = raster->shift, far = farthest(raster);
    int64_t most = (1ll << (wd - 1)) - 1, d;
    int moved = shift[0] != 0 || shift[1] != 0;
    if (!(angle > 0 && angle < 180))
        return sph_fail(err, "angle %g is not between 0 and 180 degrees", angle);
    double tangent = tan(angle * 3.14159265358979323846 / 360);

    double across = far > 0 ? (double)(most - moved) / far : 2.0 * (double)most;
    int64_t top = (int64_t)fmin(across, 2.0 * (double)most);
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
            "can tell apart: choose fewer pixels%s",
            width, height, angle, wd, moved ? ", or a lesser shift" : "");

    double least = INFINITY;
    int64_t pitch = 0;
    for (int64_t p = top; p >= 2 && 8 * p >= 7 * top; p -= 2) {
        double error = screen(height, tangent, p, &d);
        if (error < least) least = error, pitch = p;
    }
    if (!pitch) return sph_fail(err, "angle %g is too wide for %d bits of direction", angle, wd);
    screen(height, tangent, pitch, &d);
    rays->pitch = (int32_t)pitch;
    double at[2] = {shift[0] * height * (double)pitch, shift[1] * height * (double)pitch};
    double off = hypot(at[0] - (double)llround(at[0]), at[1] - (double)llround(at[1]));
    rays->x0 = (int32_t)(llround(at[0]) - (width - 1) * pitch / 2);
    rays->y0 = (int32_t)(llround(at[1]) + (height - 1) * pitch / 2);
    rays->z = (int32_t)-d;
    rays->fov_error = least + off / ((double)pitch * height / 2);
    return 0;
}

/* The same for all that a profile asks of a camera. */
static int fits(const struct sph_raster *raster, const struct sph_profile *p, struct sph_rays *rays,
                struct sph_error *err) {
    if (sph_rays_fit(raster, p->wd, rays, err)) return -1;
    if (-(int64_t)rays->z >= sph_min_screen(p)) return 0;
    return sph_fail(err, "angle %g puts the screen %d away, %d bits of the quotient need %lld",
                    raster->angle, -rays->z, p->pq, (long long)sph_min_screen(p));
}

int sph_rays_of(const struct sph_raster *raster, const struct sph_profile *profile,
                struct sph_rays *rays, struct sph_error *err) {
    struct sph_error why = {{0}};
    if (!fits(raster, profile, rays, &why)) return 0;
    for (int p = 0; p < SPH_PROFILES; p++)
        if (sph_profiles[p].wd > profile->wd && !fits(raster, &sph_profiles[p], rays, NULL))
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
static double longest(const struct sph_rays *rays, const struct sph_raster *raster,
                      const struct sph_grid *grid) {
    double most = 0, to[3];
    for (int corner = 0; corner < 4; corner++)
        for (int i = 0; i < 3; i++) {
            double x = rays->x0 + (corner & 1 ? (raster->width - 1.0) * rays->pitch : 0);
            double y = rays->y0 - (corner & 2 ? (raster->height - 1.0) * rays->pitch : 0);
            along(grid, i, to);
            most = fmax(most, fabs(to[0] * x + to[1] * y + to[2] * rays->z));
        }
    return most;
}

int sph_rays_turn(const struct sph_rays *rays, const struct sph_raster *raster,
                  const struct sph_grid *grid, const struct sph_profile *profile,
                  struct sph_steps *steps, struct sph_error *err) {
    const int width = raster->width, height = raster->height;
    /* the middle of the picture, where no step's rounding counts */
    const double x = rays->x0 + (width - 1.0) * rays->pitch / 2;
    const double y = rays->y0 - (height - 1.0) * rays->pitch / 2;
    int fraction = 32 - profile->wd;
    double room = ldexp(1, profile->wd - 1) - 3 - ldexp(width + height, -fraction); /* roundings */
    double scale = room / longest(rays, raster, grid), to[3];
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
        double middle = (to[0] * x + to[1] * y + to[2] * rays->z) * scale;
        steps->first[i] = (int32_t)lround(middle - (double)steps->across[i] * (width - 1) / 2 -
                                          (double)steps->down[i] * (height - 1) / 2) +
                          (1 << (fraction - 1)); /* half a unit: to nearest */
    }
    return 0;
}

void sph_rays_tile(const struct sph_camera *camera, int width, int height, struct sph_rays *rays,
                   struct sph_steps *steps) {
    const int x = camera->wall.column * width, y = camera->wall.row * height;
    rays->x0 += x * rays->pitch;
    rays->y0 -= y * rays->pitch;
    for (int i = 0; steps && i < 3; i++)
        steps->first[i] += x * steps->across[i] + y * steps->down[i];
}
