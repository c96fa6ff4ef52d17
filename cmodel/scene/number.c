/* number.c - decimal text to double, whatever the locale; see nff_lex.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Up to 15 digits and a power of ten up to 10^22 are both exact doubles, so that one product or
 * quotient of them is correctly rounded. That covers nearly all scene files. Longer numbers go
 * through strtod.
 */
#include "scene/nff_lex.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>

#define EXACT_DIGITS 15 /* 10^15 < 2^53 */
#define EXACT_POWER 22  /* 10^22 = 5^22 * 2^22, 5^22 < 2^53 */

/* 10^0 .. 10^22, all exact. */
static const double power_of_ten[EXACT_POWER + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

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
    int64_t whole = 0;
    int any = 0, digits = 0, exponent = 0, shift = 0, negative = *c == '-';
    if (*c == '-' || *c == '+') c++;
    for (int point = 0; is_digit(*c) || (*c == '.' && !point); c++) {
        if (*c == '.') {
            point = 1;
            continue;
        }
        any = 1;
        if (digits > 0 || *c != '0') digits++;
        if (digits <= EXACT_DIGITS) whole = 10 * whole + (*c - '0');
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
    if (digits <= EXACT_DIGITS && exponent >= -EXACT_POWER && exponent <= EXACT_POWER) {
        double size = (double)whole;
        size = exponent < 0 ? size / power_of_ten[-exponent] : size * power_of_ten[exponent];
        *value = negative ? -size : size;
    } else {
        *value = slow(text);
    }
    return fabs(*value) <= SPH_NUMBER_MAX ? 0 : -2;
}
