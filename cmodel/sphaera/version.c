/* version.c - version, errors, environment and checks of arguments of the library
 * SPDX-License-Identifier: Apache-2.0
 *
 * The build gives SPHAERA_RELEASE, the text of the file VERSION.
 */
#include <inttypes.h>
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

int sph_api_choice(const char *name, const char *word, const char *const *choices,
                   struct sph_error *err) {
    char all[256] = "";
    size_t used = 0;
    for (int i = 0; choices[i]; i++) {
        if (word && !strcmp(choices[i], word)) return i;
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i ? ", " : "", choices[i]);
    }
    return word ? sph_fail(err, "%s is '%.40s', none of %s", name, word, all)
                : sph_fail(err, "%s is NULL", name);
}

int sph_api_whole(const char *name, int64_t value, int64_t low, int64_t high,
                  struct sph_error *err) {
    if (value >= low && value <= high) return 0;
    return sph_fail(err, "%s is %" PRId64 ", not %" PRId64 " to %" PRId64, name, value, low, high);
}

int sph_api_real(const char *name, double value, double low, double high, struct sph_error *err) {
    if (value >= low && value <= high) return 0;
    return sph_fail(err, "%s is %g, not %g to %g", name, value, low, high);
}

int sph_api_show(void *user, int done, int all) {
    struct sph_api_told *told = user;
    told->end |= told->progress(told->user, done, all) != 0;
    return told->end;
}
