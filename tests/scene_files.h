/* scene_files.h - for the tests of scene files: a folder of the test, bad cases, comparing
 * SPDX-License-Identifier: Apache-2.0
 *
 * Every test program keeps its one file in a folder of its own.
 */
#ifndef SPH_TEST_SCENE_FILES_H
#define SPH_TEST_SCENE_FILES_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scene/edit.h"

static char folder[64], file_name[80]; /* of the test, and the one file in it */

static inline int make_folder(void **state) {
    (void)state;
    strcpy(folder, "/tmp/test_scene.XXXXXX");
    if (!mkdtemp(folder)) return -1;
    snprintf(file_name, sizeof file_name, "%s/scene.nff", folder);
    return 0;
}

static inline int remove_folder(void **state) {
    (void)state;
    unlink(file_name);
    return rmdir(folder);
}

static inline void put_file(const char *text, size_t n) {
    FILE *file = fopen(file_name, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, n, file), n);
    assert_int_equal(fclose(file), 0);
}

#define CAM "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 30\nhither 1\nresolution 320 180\n"
#define MAT "f 1 0 0 .5 .5 10 0 1\n" /* CAM has lines 1 to 7; this is line 8 */
#define LIGHT "l 1 2 3\n"

enum { SKIP = 1, STRICT = 2 }; /* read with skip_unsupported, with strict */

/* Input that must give a message with file, line and reason. */
struct bad {
    const char *name, *text;
    int line; /* 0: the message has no line number */
    const char *says;
    int how;    /* SKIP, STRICT */
    int length; /* 0: strlen(text) */
};

/* The message of a bad case: starts with file and line, says what it should. */
static inline void assert_message(const struct bad *bad, const struct sph_error *err) {
    char start[120];
    snprintf(start, sizeof start, bad->line ? "%s:%d: " : "%s: ", file_name, bad->line);
    if (strncmp(err->text, start, strlen(start)) != 0 || !strstr(err->text, bad->says))
        fail_msg("expected \"%s...%s...\", got \"%s\"", start, bad->says, err->text);
}

static inline void put_bad(const struct bad *bad) {
    put_file(bad->text, bad->length ? (size_t)bad->length : strlen(bad->text));
}

static inline struct sph_read_options bad_options(const struct bad *bad) {
    return (struct sph_read_options){.skip_unsupported = bad->how & SKIP,
                                     .strict = bad->how & STRICT};
}

static inline void assert_same_bytes(const void *p, const void *q, size_t n) {
    assert_memory_equal(p, q, n);
}

/* Same camera, lights, colours, spheres and materials, to the last bit. */
static inline void assert_same_scene(const struct sph_scene *p, const struct sph_scene *q) {
    assert_same_bytes(&p->camera, &q->camera, sizeof p->camera);
    assert_same_bytes(p->background, q->background, sizeof p->background);
    assert_same_bytes(p->ambient, q->ambient, sizeof p->ambient);
    assert_int_equal(p->n_lights, q->n_lights);
    for (int i = 0; i < p->n_lights; i++)
        assert_same_bytes(&p->lights[i], &q->lights[i], offsetof(struct sph_light, line));
    assert_int_equal(p->n_spheres, q->n_spheres);
    for (uint32_t i = 0; i < p->n_spheres; i++) {
        const struct sph_sphere *s = &p->spheres[i], *t = &q->spheres[i];
        assert_same_bytes(&s->ctr, &t->ctr, sizeof s->ctr);
        assert_true(s->rad == t->rad);
        const struct sph_material *m = &p->materials[s->material], *n = &q->materials[t->material];
        assert_same_bytes(m, n, offsetof(struct sph_material, line));
        assert_int_equal(m->sum.hollow, n->sum.hollow);
        assert_true(m->sum.around == n->sum.around);
        assert_int_equal(m->passes, n->passes);
    }
}

/* Same facets, and primitives with the same textures; the numbers of the textures may differ. */
static inline void assert_same_texture(const struct sph_scene *p, uint32_t i,
                                       const struct sph_scene *q, uint32_t j) {
    if (!i || !j) {
        assert_int_equal(i, j);
        return;
    }
    const struct sph_texture *s = &p->textures[i - 1], *t = &q->textures[j - 1];
    assert_string_equal(s->path, t->path);
    assert_same_bytes(s->wrap, t->wrap, sizeof s->wrap);
    assert_same_bytes(s->repeat, t->repeat, sizeof s->repeat);
    assert_same_bytes(s->offset, t->offset, sizeof s->offset);
}

static inline void assert_same_facets(const struct sph_scene *p, const struct sph_scene *q) {
    for (uint32_t i = 0; i < p->n_spheres; i++)
        assert_same_texture(p, p->spheres[i].texture, q, q->spheres[i].texture);
    assert_int_equal(p->n_facets, q->n_facets);
    for (uint32_t i = 0; i < p->n_facets; i++) {
        const struct sph_facet *s = &p->facets[i], *t = &q->facets[i];
        assert_int_equal(s->kind, t->kind);
        assert_int_equal(s->group, t->group);
        assert_same_bytes(s->v, t->v, sizeof s->v);
        assert_same_bytes(s->st, t->st, sizeof s->st);
        assert_int_equal(s->smooth, t->smooth);
        if (s->smooth) assert_same_bytes(s->n, t->n, sizeof s->n);
        assert_same_texture(p, s->texture, q, t->texture);
        const struct sph_material *m = &p->materials[s->material], *n = &q->materials[t->material];
        assert_same_bytes(m, n, offsetof(struct sph_material, line));
        assert_int_equal(m->sum.hollow, n->sum.hollow);
        assert_true(m->sum.around == n->sum.around);
        assert_int_equal(m->passes, n->passes);
    }
}

static inline void round_trip(const struct sph_scene *scene) {
    struct sph_error err = {""};
    struct sph_scene again;
    FILE *file = fopen(file_name, "w");
    assert_non_null(file);
    assert_int_equal(sph_scene_write(scene, file, &err), 0);
    fclose(file);
    if (sph_scene_read(file_name, NULL, &again, &err)) fail_msg("%s", err.text);
    assert_same_scene(scene, &again);
    assert_same_facets(scene, &again);
    sph_scene_free(&again);
}

/* Runs function once for every bad case, and then the other tests. */
static inline int run_cases(const char *name, void (*function)(void **), const struct bad *bads,
                            size_t n_bads, const struct CMUnitTest *others, size_t n_others) {
    struct CMUnitTest all[128];
    for (size_t i = 0; i < n_bads; i++)
        all[i] =
            (struct CMUnitTest){bads[i].name, function, NULL, NULL, (void *)(uintptr_t)&bads[i]};
    memcpy(all + n_bads, others, n_others * sizeof *others);
    for (size_t i = n_bads + n_others; i < 128; i++)
        all[i] = (struct CMUnitTest){0};
    return _cmocka_run_group_tests(name, all, n_bads + n_others, make_folder, remove_folder);
}

#endif
