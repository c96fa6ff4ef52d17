/* math.h - the rounded steps of the machine, by definition, in GMP
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_NAIVE_MATH_H
#define SPH_NAIVE_MATH_H

#include <gmp.h>
#include <stdint.h>

#include "machine/profile.h"

/* x = floor(x / 2^n + 1/2); a negative n multiplies by 2^-n. */
void sph_naive_round(mpz_t x, long n);

/* The same for numbers that fit an int64 with room to spare, n >= 0. */
int64_t sph_naive_round64(int64_t x, int n);

/* x limited to -2^(bits-1) .. 2^(bits-1)-1. */
int64_t sph_naive_limit(const mpz_t x, int bits);

/* *mant = floor(key / a * 2^exp) with exp = pq - 1 + length(a) - length(key), lengths in bits:
 * returns exp. Both operands > 0. */
long sph_naive_quotient(uint64_t key, uint64_t a, int pq, uint64_t *mant);

/* v[0..2] by one shift to s(bits): the longest component fills the word; right shifts round half
 * up and are limited. Components that are all 0 or -1 have no length and stay as they are. */
void sph_naive_normalise(mpz_t v[3], int bits, int64_t out[3]);

/* About 2^(bits + 16 - *h) / |v| by the machine's table of inverse square roots, 0 if |v| is 0; *h
 * is the least for which |v| * 2^h is 2^(bits - 1) or more. v: s(bits). */
uint64_t sph_naive_inverse_length(const int64_t v[3], int bits, int *h);

/* v / |v| as s1.16 with the machine's table of inverse square roots; v: s(bits). */
void sph_naive_unit(const int64_t v[3], int bits, int64_t u[3]);

/* ---- Snell's law and highlights by definition ---- */

/* The direction behind a surface with normal n, any length, of a ray that comes along d with index
 * `from` on its side and `to` on the other. 0 if all is reflected. */
int sph_naive_refract(const struct sph_profile *p, const int64_t d[3], const int64_t n[3],
                      uint32_t from, uint32_t to, int64_t out[3]);

/* max(0, cosine of mirrored light and way back)^(power/16), u1.15, of unit vectors s1.16: normal,
 * to the light, along the ray. */
int64_t sph_naive_specular(const int64_t n[3], const int64_t l[3], const int64_t d[3],
                           uint32_t power);

#endif
