/* scene_list.h - the scenes that patterns name: files, and of FILE:* each scene of the file
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_SCENE_LIST_H
#define SPH_TEST_SCENE_LIST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <glob.h>
#include <stdio.h>
#include <string.h>

struct scene_list {
    size_t n;
    char name[256][192]; /* as sph_scene_read() takes it */
};

static inline void list_one(struct scene_list *list, const char *file, const char *section) {
    assert_true(list->n < sizeof list->name / sizeof *list->name);
    snprintf(list->name[list->n++], sizeof *list->name, "%s%s%s", file, section ? ":" : "",
             section ? section : "");
}

/* n patterns; a test of none would pass, so that fails. */
static inline struct scene_list list_scenes(const char *const *patterns, size_t n) {
    struct scene_list list = {.n = 0};
    char path[96], line[128];
    for (size_t i = 0; i < n; i++) {
        glob_t found;
        const char *colon = strstr(patterns[i], ":*");
        snprintf(path, sizeof path, "%s", patterns[i]);
        if (colon) path[colon - patterns[i]] = 0;
        assert_int_equal(glob(path, 0, NULL, &found), 0);
        for (size_t k = 0; k < found.gl_pathc && !colon; k++)
            list_one(&list, found.gl_pathv[k], NULL);
        FILE *file = colon ? fopen(path, "r") : NULL;
        while (file && fgets(line, sizeof line, file))
            if (!strncmp(line, "scene ", strlen("scene ")))
                list_one(&list, path, strtok(line + strlen("scene "), " \r\n"));
        if (file) fclose(file);
        globfree(&found);
    }
    return list;
}

#endif
