/* spline.c - see spline.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/spline.h"

#include <stdlib.h>

/* The piece that a time lies on: from key[at] to key[at + 1], a part u of it. */
struct piece {
    uint32_t at;
    double u;
    double out[2], in[2]; /* weights of the steps before and behind, in the tangents of both ends */
};

/* Weights of the step before and the step behind a key; forward: in the tangent that leaves it.
 * part: of the piece in the time between its neighbours. */
static void weigh(const struct sph_key *key, int forward, double part, double weight[2]) {
    if (!(part > 0 && part <= 1)) part = 1; /* times that fall */
    double c = forward ? key->continuity : -key->continuity;
    weight[0] = part * (1 - key->tension) * (1 + c) * (1 + key->bias);
    weight[1] = part * (1 - key->tension) * (1 - c) * (1 - key->bias);
}

static struct piece piece_of(const struct sph_key *key, uint32_t n, double time) {
    struct piece p = {.at = 1};
    if (time >= key[n - 2].time)
        p.at = n - 3, p.u = 1;
    else if (time > key[1].time) {
        while (time >= key[p.at + 1].time)
            p.at++;
        double length = key[p.at + 1].time - key[p.at].time;
        p.u = length > 0 ? fmax(0, (time - key[p.at].time) / length) : 0;
    }
    const struct sph_key *k = key + p.at;
    double length = k[1].time - k[0].time;
    if (!(length > 0)) return p;
    weigh(&k[0], 1, length / (k[1].time - k[-1].time), p.out);
    weigh(&k[1], 0, length / (k[2].time - k[0].time), p.in);
    return p;
}

/* The cubic with both ends and both tangents. */
static double cubic(double from, double step, double out, double in, double u) {
    return from + u * (out + u * (3 * step - 2 * out - in + u * (out + in - 2 * step)));
}

struct sph_vec sph_spline_point(const struct sph_key *key, uint32_t n, double time) {
    struct piece p = piece_of(key, n, time);
    const struct sph_key *k = key + p.at;
    struct sph_vec a = sph_vec_sub(k[0].at, k[-1].at), b = sph_vec_sub(k[1].at, k[0].at),
                   c = sph_vec_sub(k[2].at, k[1].at);
    return (struct sph_vec){
        cubic(k[0].at.x, b.x, p.out[0] * a.x + p.out[1] * b.x, p.in[0] * b.x + p.in[1] * c.x, p.u),
        cubic(k[0].at.y, b.y, p.out[0] * a.y + p.out[1] * b.y, p.in[0] * b.y + p.in[1] * c.y, p.u),
        cubic(k[0].at.z, b.z, p.out[0] * a.z + p.out[1] * b.z, p.in[0] * b.z + p.in[1] * c.z, p.u)};
}

static double dot(struct sph_turn a, struct sph_turn b) {
    return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct sph_turn product(struct sph_turn a, struct sph_turn b) {
    return (struct sph_turn){a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                             a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                             a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                             a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/* a p + b q. */
static struct sph_turn sum(double a, struct sph_turn p, double b, struct sph_turn q) {
    return (struct sph_turn){a * p.w + b * q.w, a * p.x + b * q.x, a * p.y + b * q.y,
                             a * p.z + b * q.z};
}

/* The logarithm of what turns a into b: half the angle along the axis, w = 0. */
static struct sph_turn step(struct sph_turn a, struct sph_turn b) {
    struct sph_turn back = {a.w, -a.x, -a.y, -a.z}, d = product(back, b);
    double length = sph_vec_length((struct sph_vec){d.x, d.y, d.z});
    double by = length > 0 ? atan2(length, d.w) / length : 1;
    return (struct sph_turn){0, by * d.x, by * d.y, by * d.z};
}

/* p, turned on by what log is the logarithm of. */
static struct sph_turn turned(struct sph_turn p, struct sph_turn log) {
    double angle = sph_vec_length((struct sph_vec){log.x, log.y, log.z});
    double by = angle > 0 ? sin(angle) / angle : 1;
    return product(p, (struct sph_turn){cos(angle), by * log.x, by * log.y, by * log.z});
}

/* Along the great circle from p to q. */
static struct sph_turn between(struct sph_turn p, struct sph_turn q, double u) {
    return turned(p, sum(u, step(p, q), 0, p));
}

int sph_spline_turn(const struct sph_key *key, uint32_t n, double time, struct sph_turn *turn) {
    struct piece p = piece_of(key, n, time);
    struct sph_turn *all = malloc(n * sizeof *all), *q = all;
    if (!all) return -1;
    for (uint32_t i = 0; i < n; i++) {
        q[i] = sph_turn_of(key[i].at, key[i].degrees);
        if (i > 0 && dot(q[i], q[i - 1]) < 0) q[i] = sum(-1, q[i], 0, q[i]);
    }
    q += p.at;
    struct sph_turn a = step(q[-1], q[0]), b = step(q[0], q[1]), c = step(q[1], q[2]);
    struct sph_turn out = sum(p.out[0], a, p.out[1], b), in = sum(p.in[0], b, p.in[1], c);
    struct sph_turn near = turned(q[0], sum(0.5, out, -0.5, b));
    struct sph_turn far = turned(q[1], sum(0.5, b, -0.5, in));
    *turn = between(between(q[0], q[1], p.u), between(near, far, p.u), 2 * p.u * (1 - p.u));
    free(all);
    return 0;
}

double sph_affine_scale(const struct sph_affine *a) {
    const double close = 1e-9; /* what rounding leaves, as a part */
    struct sph_vec axis[3];
    double size[3];
    for (int k = 0; k < 3; k++) {
        axis[k] = (struct sph_vec){a->m[0][k], a->m[1][k], a->m[2][k]};
        size[k] = sph_vec_length(axis[k]);
    }
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        if (!(fabs(size[k] - size[next]) <= close * size[k]) ||
            !(fabs(sph_vec_dot(axis[k], axis[next])) <= close * size[k] * size[next]))
            return 0;
    }
    return size[0];
}
