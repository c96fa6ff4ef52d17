/* harness_mesh.c - meshes: OBJ, PLY, STL, glTF, by the whole way through a child and assimp
 * SPDX-License-Identifier: Apache-2.0
 *
 * What reads is in this program, sanitized, and not in an object that is loaded. assimp may fall:
 * that is what the child is for. Whatever a sanitizer stops there is ours.
 */
#include <dlfcn.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "common/kind.h"
#include "fuzz.h"
#include "scene/import.h"

/* A sanitizer's report ends the child by its exit code; only what has no instruments, and that is
 * assimp, ends it by a signal. */
void __asan_on_error(void);
void __ubsan_on_report(void);
const char *__asan_get_report_description(void) __attribute__((weak));
static int is_child;

void __asan_on_error(void) {
    if (is_child && !strstr(__asan_get_report_description(), "SEGV")) _exit(1);
}

void __ubsan_on_report(void) {
    if (is_child) _exit(1);
}

/* Instead of the one that loads an object: the child calls it. */
void *__wrap_sph_module_load(const char *name, char *why, size_t size);
void *__wrap_sph_module_load(const char *name, char *why, size_t size) {
    (void)name, (void)why, (void)size;
    is_child = 1;
    signal(SIGABRT, SIG_DFL);
    return dlopen(NULL, RTLD_NOW);
}

void fuzz_begin(const char *root) {
    static const char mtl[] = "newmtl glass\nKd .5 1 0\nKs .1 .1 .2\nNs 9\nd .5\nNi 1.5\n"
                              "newmtl metal\nKd 2 0 0\nKs 1 1 1\nillum 3\nKa 1 1 1\n";
    (void)root;
    fuzz_write("m.mtl", (const uint8_t *)mtl, sizeof mtl - 1);
}

/* What a file is read as: by its first bytes. */
static enum sph_file_kind kind_of(const uint8_t *data, size_t size) {
    char first = (char)(size ? data[0] : 0);
    return first == 'p'             ? SPH_FILE_PLY
           : first == '{'           ? SPH_FILE_GLTF
           : first == 'g'           ? SPH_FILE_GLB
           : first == 's' || !first ? SPH_FILE_STL
                                    : SPH_FILE_OBJ;
}

void fuzz_one(const uint8_t *data, size_t size) {
    static const char fallen[] = "mesh: assimp fell over this file";
    struct sph_scene scene;
    struct sph_error err = {""};
    uint64_t choice = fuzz_hash(data, size);
    struct sph_import_options o = {.skip = choice >> 60 & 1, .strict = !(choice >> 56 & 7)};
    fuzz_write("mesh", data, size);
    if (sph_import("mesh", kind_of(data, size), &o, &scene, &err)) {
        fuzz_message(&err, strncmp(err.text, "m.mtl", 5) ? "mesh" : "m.mtl", 0);
        if (!strcmp(err.text, fallen)) fuzz_fail("a sanitizer ended the child");
        return;
    }
    fuzz_scene(&scene, choice);
    sph_scene_free(&scene);
}
