/* version.c - version, errors and environment of the library
 * SPDX-License-Identifier: Apache-2.0
 *
 * The build gives SPHAERA_RELEASE, the text of the file VERSION.
 */
#include <string.h>

#include "sphaera/opaque.h"

const char *sphaera_version(void) {
    return SPHAERA_RELEASE;
}

void sph_api_enter(fenv_t *callers) {
    fegetenv(callers);
    fesetenv(FE_DFL_ENV);
}

void sph_api_leave(fenv_t *callers) {
    fesetenv(callers);
}

int sph_api_failed(const struct sph_error *from, sphaera_error *to) {
    _Static_assert(sizeof to->text >= sizeof from->text, "a message fits");
    if (to) memcpy(to->text, from->text, sizeof from->text);
    return -1;
}

int sph_api_null(const void *argument, const char *name, sphaera_error *to) {
    struct sph_error err = {""};
    if (argument) return 0;
    sph_fail(&err, "%s is NULL", name);
    sph_api_failed(&err, to);
    return 1;
}
