/* screen.c - see screen.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/screen.h"

#include <dlfcn.h>

#include "common/module.h"

const struct view_screen_calls *view_screen_load(struct sph_error *err) {
    char why[4096] = "it has no window";
    void *module = sph_module_load("view", why, sizeof why);
    const void *calls = module ? dlsym(module, "view_screen_sdl") : NULL;
    if (!calls)
        sph_fail(err,
                 "there is no live view: %.300s; it needs SDL2: `make view-setup` installs it and "
                 "makes the tool again",
                 why);
    return calls;
}
