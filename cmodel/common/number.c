/* number.c - text to numbers, whatever the locale; see number.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Of doubles: up to 15 digits and a power of ten up to 10^22 are both exact doubles, so that one
 * product or quotient of them is correctly rounded. That covers nearly all scene files. Of up to 19
 * digits and 10^27 a long double has the quotient within half of its own last bit, which is enough
 * unless a double lies that near to the middle of two. The rest goes through strtod.
 */
#include "common/number.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>

#define EXACT_DIGITS 15 /* 10^15 < 2^53 */
#define EXACT_POWER 22  /* 10^22 = 5^22 * 2^22, 5^22 < 2^53 */

/* 10^0 .. 10^22, all exact. */
static const double power_of_ten[EXACT_POWER + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* The same of long doubles that have 64 bits: 5^27 < 2^64. */
#define MOST_DIGITS 19
#define MOST_POWER 27
static const long double power_beyond[MOST_POWER - EXACT_POWER + 1] = {1e22L, 1e23L, 1e24L,
                                                                       1e25L, 1e26L, 1e27L};

/* whole * 10^exponent by long doubles; 0 if two doubles are about as near. */
static int long_way(uint64_t whole, int exponent, double *size) {
#if LDBL_MANT_DIG >= 64
    int n = exponent < 0 ? -exponent : exponent;
    long double power = n <= EXACT_POWER ? power_of_ten[n] : power_beyond[n - EXACT_POWER];
    long double x = exponent < 0 ? whole / power : whole * power, off = x * LDBL_EPSILON;
    *size = (double)(x + off);
    return *size == (double)(x - off);
#else
    return (void)whole, (void)exponent, (void)size, 0;
#endif
}

static int is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* strtod in the C locale. */
static double slow(const char *text) {
    locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    double value = c_locale ? strtod_l(text, NULL, c_locale) : strtod(text, NULL);
    if (c_locale) freelocale(c_locale);
    return value;
}

int sph_parse_number(const char *text, double *value) {
    const char *c = text;
    uint64_t whole = 0;
    int any = 0, digits = 0, exponent = 0, shift = 0, negative = *c == '-';
    if (*c == '-' || *c == '+') c++;
    for (int point = 0; is_digit(*c) || (*c == '.' && !point); c++) {
        if (*c == '.') {
            point = 1;
            continue;
        }
        any = 1;
        if (digits > 0 || *c != '0') digits++;
        if (digits <= MOST_DIGITS) whole = 10 * whole + (uint64_t)(*c - '0');
        shift -= point;
    }
    if (!any) return -1;
    if (*c == 'e' || *c == 'E') {
        int minus = *++c == '-';
        if (*c == '-' || *c == '+') c++;
        if (!is_digit(*c)) return -1;
        for (; is_digit(*c); c++)
            if (exponent < 10000) exponent = 10 * exponent + (*c - '0');
        if (minus) exponent = -exponent;
    }
    if (*c) return -1;
    exponent += shift;
    double size = (double)whole;
    int n = exponent < 0 ? -exponent : exponent;
    if (digits <= EXACT_DIGITS && n <= EXACT_POWER)
        size = exponent < 0 ? size / power_of_ten[n] : size * power_of_ten[n];
    else if (digits > MOST_DIGITS || n > MOST_POWER || !long_way(whole, exponent, &size))
        size = fabs(slow(text));
    *value = negative ? -size : size;
    return fabs(*value) <= SPH_NUMBER_MAX ? 0 : -2;
}

static int digit_of(char c, int base) {
    int value = is_digit(c)                          ? c - '0'
                : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10
                                                     : 16;
    return value < base ? value : -1;
}

/* Digits of a base, of which there is one at least. */
static int take_digits(const char **text, int base, uint64_t most, uint64_t *value) {
    const char *c = *text;
    uint64_t sum = 0;
    if (digit_of(*c, base) < 0) return -1;
    for (; digit_of(*c, base) >= 0; c++) {
        uint64_t digit = (uint64_t)digit_of(*c, base), b = (uint64_t)base;
        if (digit > most || sum > (most - digit) / b) return -1;
        sum = b * sum + digit;
    }
    *value = sum;
    *text = c;
    return 0;
}

int sph_take_count(const char **text, uint64_t low, uint64_t high, uint64_t *value) {
    const char *c = *text;
    uint64_t v;
    if (take_digits(&c, 10, high, &v) || v < low) return -1;
    *value = v;
    *text = c;
    return 0;
}

int sph_take_hex(const char **text, uint64_t high, uint64_t *value) {
    return take_digits(text, 16, high, value);
}

int sph_take_whole(const char **text, int64_t low, int64_t high, int64_t *value) {
    const char *c = *text;
    int negative = *c == '-';
    uint64_t size, most = negative ? (uint64_t)INT64_MAX + 1 : (uint64_t)INT64_MAX;
    c += negative;
    int hex = c[0] == '0' && (c[1] | 32) == 'x';
    if (hex) c += 2;
    if (take_digits(&c, hex ? 16 : 10, most, &size)) return -1;
    int64_t v = negative ? (int64_t)(0 - size) : (int64_t)size;
    if (v < low || v > high) return -1;
    *value = v;
    *text = c;
    return 0;
}
