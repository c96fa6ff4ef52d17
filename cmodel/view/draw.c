/* draw.c - rays as lines over a picture; see pick.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "view/camera.h"
#include "view/pick.h"

enum { CROSS = 5 }; /* pixels of an arm */
static const uint32_t white = 0xffffff, black = 0, yellow = 0x00ffff, red = 0x0000ff,
                      cyan = 0xffff00, magenta = 0xff00ff;

struct canvas {
    int width, height;
    uint32_t *pixels;
};

/* Leaves of a line from a to b the part between 0 and most along one axis (Liang and Barsky). */
static void clip(double from, double along, double most, double *first, double *last) {
    double a = -from / along, b = (most - from) / along;
    if (along == 0) {
        if (from < 0 || from > most) *last = -1;
        return;
    }
    *first = fmax(*first, fmin(a, b));
    *last = fmin(*last, fmax(a, b));
}

static void line(const struct canvas *c, const double e[4], uint32_t colour) {
    double x = e[2] - e[0], y = e[3] - e[1], first = 0, last = 1;
    clip(e[0], x, c->width - 1, &first, &last);
    clip(e[1], y, c->height - 1, &first, &last);
    if (!(first <= last)) return;
    int steps = (int)ceil((last - first) * fmax(fabs(x), fabs(y))) + 1;
    for (int i = 0; i <= steps; i++) {
        double at = first + (last - first) * i / steps;
        size_t px = (size_t)lround(e[0] + at * x), py = (size_t)lround(e[1] + at * y);
        if (px < (size_t)c->width && py < (size_t)c->height)
            c->pixels[py * (size_t)c->width + px] = colour;
    }
}

/* Black around white: it is seen on any picture. The pixel itself stays as it is. */
static void cross(const struct canvas *c, int x, int y) {
    for (int i = 2; i <= CROSS; i++)
        for (int k = -1; k <= 1; k++) {
            uint32_t colour = k ? black : white;
            const double at[][4] = {{x - i, y + k, x - i, y + k},
                                    {x + i, y + k, x + i, y + k},
                                    {x + k, y - i, x + k, y - i},
                                    {x + k, y + i, x + k, y + i}};
            for (int d = 0; d < 4; d++)
                line(c, at[d], colour);
        }
}

static uint32_t colour_of(const struct view_ray *r) {
    if (r->kind == SPH_SHADOW) return r->hit ? red : yellow;
    return r->kind == SPH_REFRACTED ? magenta : cyan;
}

void view_rays_draw(const struct view_rays *rays, const struct sph_camera *camera, int width,
                    int height, uint32_t *pixels) {
    struct canvas c = {width, height, pixels};
    double ends[4];
    for (int i = 0; i < rays->n; i++) {
        const struct view_ray *r = &rays->list[i];
        if (view_line(camera, width, height, r->from, r->to, ends)) line(&c, ends, colour_of(r));
    }
    struct view_ray seen = {0};
    if (rays->n) seen = rays->list[0];
    struct sph_vec end = seen.to;
    if (rays->n && view_line(camera, width, height, end, end, ends) && fabs(ends[0]) < width &&
        fabs(ends[1]) < height)
        cross(&c, (int)lround(ends[0]), (int)lround(ends[1]));
}
