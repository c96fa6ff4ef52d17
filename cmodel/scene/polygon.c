/* polygon.c - see polygon.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/polygon.h"

#include <math.h>
#include <string.h>

#include "scene/ears.h"
#include "scene/vector.h"

#define EMPTY 1e-12 /* of the squared size: what rounding leaves of the area of a line */

/* Twice the area as a vector. */
static struct sph_vec area(struct sph_vec a, struct sph_vec b, struct sph_vec c) {
    return sph_vec_cross(sph_vec_sub(b, a), sph_vec_sub(c, a));
}

int sph_triangle_empty(struct sph_vec a, struct sph_vec b, struct sph_vec c) {
    double size = fmax(sph_vec_length(sph_vec_sub(b, a)), sph_vec_length(sph_vec_sub(c, a)));
    return !(sph_vec_length(area(a, b, c)) > EMPTY * size * size);
}

int sph_parallel(struct sph_vec a, struct sph_vec b) {
    return !(sph_vec_length(sph_vec_cross(a, b)) > EMPTY * sph_vec_length(a) * sph_vec_length(b));
}

/* The greatest distance of a corner from the plane through their middle. unit: the normal. */
static double off_plane(const struct sph_vec *corner, int n, struct sph_vec unit) {
    double mean = 0, most = 0;
    for (int i = 0; i < n; i++)
        mean += sph_vec_dot(sph_vec_sub(corner[i], corner[0]), unit) / n;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(sph_vec_dot(sph_vec_sub(corner[i], corner[0]), unit) - mean));
    return most;
}

/* Whether the outline turns back nowhere. unit: the normal. */
static int is_convex(const struct sph_vec *corner, int n, struct sph_vec unit, double size) {
    for (int i = 0; i < n; i++) {
        struct sph_vec a = corner[i], b = corner[(i + 1) % n], c = corner[(i + 2) % n];
        double chord = sph_vec_length(sph_vec_sub(c, a));
        if (sph_vec_dot(area(a, b, c), unit) < -SPH_POLYGON_CONVEX * size * chord ||
            (i > 0 && i < n - 1 &&
             sph_vec_dot(area(corner[0], a, b), unit) < -SPH_POLYGON_CONVEX * size * size))
            return 0;
    }
    return 1;
}

/* Triangles without area in the fan from corner `first`. */
static int empty_pieces(const struct sph_vec *corner, int n, int first) {
    int empty = 0;
    for (int i = 1; i < n - 1; i++)
        empty +=
            sph_triangle_empty(corner[first], corner[(first + i) % n], corner[(first + i + 1) % n]);
    return empty;
}

/* The fan of a convex polygon. */
static void fan(const struct sph_vec *corner, int n, int (*index)[3]) {
    int first = 0, fewest = empty_pieces(corner, n, 0);
    for (int i = 1; i < n && fewest; i++) {
        int empty = empty_pieces(corner, n, i);
        if (empty < fewest) fewest = empty, first = i;
    }
    for (int i = 1; i < n - 1; i++) {
        index[i - 1][0] = first;
        index[i - 1][1] = (first + i) % n;
        index[i - 1][2] = (first + i + 1) % n;
    }
}

int sph_polygon_cut(const struct sph_vec *corner, int n, int (*index)[3], double *bent,
                    struct sph_error *err) {
    struct sph_vec normal = {0, 0, 0}, most = {0, 0, 0};
    double size = 0;
    for (int i = 1; i < n; i++) {
        size = fmax(size, sph_vec_length(sph_vec_sub(corner[i], corner[0])));
        if (i == n - 1) break;
        struct sph_vec more = area(corner[0], corner[i], corner[i + 1]);
        normal = (struct sph_vec){normal.x + more.x, normal.y + more.y, normal.z + more.z};
        if (sph_vec_length(more) > sph_vec_length(most)) most = more;
    }
    double twice = sph_vec_length(normal);
    /* Without area, but not a line: its edges cross, and what is left and right of it cancels. */
    if (!(twice > EMPTY * size * size) && sph_vec_length(most) > EMPTY * size * size &&
        sph_polygon_ears(corner, n, most, index, err))
        return -1;
    *bent = 0;
    if (!(twice > EMPTY * size * size)) return 0;
    struct sph_vec unit = {normal.x / twice, normal.y / twice, normal.z / twice};
    if (is_convex(corner, n, unit, size))
        fan(corner, n, index);
    else if (sph_polygon_ears(corner, n, unit, index, err))
        return -1;
    double off = off_plane(corner, n, unit);
    *bent = off > SPH_POLYGON_FLAT * size ? off : 0;
    int count = 0;
    for (int i = 0; i < n - 2; i++) {
        const int *t = index[i];
        if (sph_triangle_empty(corner[t[0]], corner[t[1]], corner[t[2]])) continue;
        memmove(index[count++], t, sizeof index[0]);
    }
    return count;
}
