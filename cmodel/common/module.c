/* module.c - see module.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/module.h"

#include <dlfcn.h>
#include <link.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { LONGEST = 4096 };

/* Seen from the folder of the tool or of the library: beside it; of what is installed in
 * PREFIX/bin or PREFIX/lib; of the library in the build folder. */
static const char *const places[] = {"sphaera_", "../lib/sphaera/", "../sphaera_"};
enum { PLACES = sizeof places / sizeof *places };

/* The file that this code is in, the program or a shared library; -1: not known. */
static ssize_t own_place(char *self, size_t size) {
    Dl_info info;
    struct link_map *map = NULL;
    if (dladdr1(places, &info, (void **)&map, RTLD_DL_LINKMAP) && map && map->l_name[0])
        return snprintf(self, size, "%s", map->l_name);
    ssize_t length = readlink("/proc/self/exe", self, size - 1);
    if (length >= 0) self[length] = 0;
    return length;
}

void *sph_module_load(const char *name, char *why, size_t size) {
    char self[LONGEST], path[LONGEST + 64];
    ssize_t length = own_place(self, sizeof self);
    if (length < 0 || length >= LONGEST) {
        snprintf(why, size, "the folder of tool or library is not known");
        return NULL;
    }
    char *slash = strrchr(self, '/');
    int folder = slash ? (int)(slash - self) : 0;
    void *object = NULL;
    for (int i = 0; i < PLACES && !object; i++) {
        snprintf(path, sizeof path, "%.*s/%s%s.so", folder, self, places[i], name);
        if (i && access(path, F_OK)) continue; /* the first one's message is of use */
        object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
        if (!object) snprintf(why, size, "%s", dlerror());
    }
    return object;
}
