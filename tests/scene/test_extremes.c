/* test_extremes.c - numbers as small, large and alike as files can have: an answer within a second
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each number of each file below takes each value, one at a time, then all numbers of a line do.
 * The file is read, built as `sphaera render` does, and drawn: there is a frame, or a message that
 * begins with the file's name. Without ALL=1 each number takes every twelfth value, another in each
 * place.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <ctype.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "builder/profile/build_auto.h"
#include "render/render.h"
#include "sanitized.h"
#include "scene/pdb_import.h"

static const char *const values[] = {
    "5e-324",  /* the least denormal number */
    "-1e-320", /* another, negative */
    "1e-310",  /* one whose reciprocal is infinite */
    "1e-300",  /* whose square is 0 */
    "1e-30",   /* below what a float's square holds */
    "0",       /* equal coordinates, no size */
    "1",       /* equal coordinates */
    "-1",      "1e9", "-1e17", "1e30", "1e300", "-1.7e308",
};
enum { VALUES = sizeof values / sizeof *values, SECONDS = SANITIZED ? 10 : 1 };

/* What the child is at, for whoever finds it dead. */
static struct {
    size_t from, to; /* bytes of the file that are replaced */
    int whole_line, cases;
    char message[600];
} * at;

/* The text with the numbers in from..to replaced; a field of a PDB file keeps its columns. */
static size_t replaced(const char *text, size_t n, const char *value, int columns, char *out) {
    size_t used = 0;
    for (size_t i = 0; i < n;) {
        size_t end = i;
        while (end < n && (isalnum((unsigned char)text[end]) || strchr("+-.", text[end])))
            end++;
        if (i >= at->from && end <= at->to && end > i &&
            strpbrk(text + i, "0123456789") < text + end && !isalpha((unsigned char)text[i])) {
            used += (size_t)sprintf(out + used, columns ? "%*s" : "%.*s%s",
                                    (int)(columns ? end - i : 0), columns ? value : "",
                                    columns ? "" : value);
            i = end;
        } else if (end > i) {
            memcpy(out + used, text + i, end - i);
            used += end - i, i = end;
        } else {
            out[used++] = text[i++];
        }
    }
    return used;
}

static int read_scene(const char *path, struct sph_scene *scene, struct sph_error *err) {
    const struct sph_read_options options = {.skip_unsupported = 1, .at = 1};
    return strstr(path, ".pdb") ? sph_import_pdb(path, NULL, scene, err)
                                : sph_scene_read(path, &options, scene, err);
}

/* Reads, builds, draws; 0 if what it says is no message with the file's name. */
static int answered(const char *path) {
    static struct sph_build_report report;
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_keep keep = {SPH_KEEP_PIXELS, SPH_KEEP_PSNR};
    struct sph_profile_choice choice;
    struct sph_scene scene;
    struct sph_machine m;
    struct sph_error err = {""};
    const struct itimerval limit = {{0, 0}, {SECONDS, 0}}, none = {{0, 0}, {0, 0}};
    o.width = 16, o.height = 9;
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
    if (!read_scene(path, &scene, &err)) {
        scene.n_textures = 0; /* images are no numbers */
        for (uint32_t i = 0; i < scene.n_spheres; i++)
            scene.spheres[i].texture = 0;
        for (uint32_t i = 0; i < scene.n_facets; i++)
            scene.facets[i].texture = 0;
        if (!sph_build_auto(&scene, &o, &keep, &choice, &m, &report, &err)) {
            struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST, .threads = 1};
            struct sph_counters counters = {{0}};
            struct sph_frame frame = {0};
            if (sph_render(&m, &how, &frame, &counters, &err) > 0)
                snprintf(err.text, sizeof err.text, "the frame has errors");
            sph_frame_free(&frame);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    setitimer(ITIMER_VIRTUAL, &none, NULL);
    snprintf(at->message, sizeof at->message, "%s", err.text);
    return !err.text[0] || !strncmp(err.text, path, strlen(path));
}

/* Puts the value for each number of the text, and for those of each line. */
static void child(const char *text, size_t n, const char *value, const char *path, int turn) {
    int columns = strstr(path, ".pdb") != NULL;
    char *out = malloc(n * 12 + 64);
    int all = getenv("ALL") != NULL, of = all ? 1 : SANITIZED ? 48 : 12;
    for (int whole = 0; whole < 2; whole++) {
        at->whole_line = whole;
        for (size_t i = 0; i < n; i++) {
            int starts = whole ? !i || text[i - 1] == '\n'
                               : isdigit((unsigned char)text[i]) || strchr("+-.", text[i]);
            if (!whole && i && !isspace((unsigned char)text[i - 1])) starts = 0;
            if (!starts || turn++ % of) continue;
            size_t end = i;
            while (end < n && (whole ? text[end] != '\n' : !isspace((unsigned char)text[end])))
                end++;
            at->from = i, at->to = end;
            FILE *file = fopen(path, "wb");
            if (!file) _exit(3);
            fwrite(out, 1, replaced(text, n, value, columns, out), file);
            fclose(file);
            at->cases++;
            if (!answered(path)) _exit(2);
            i = end - (end > i);
        }
    }
    free(out);
}

static void try_file(const char *name) {
    static char text[4096];
    FILE *file = fopen(name, "rb");
    assert_non_null(file);
    size_t n = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[n] = 0;
    char folder[] = "/tmp/test_extremes.XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    const char *kind = strstr(name, "/pdb/") ? "pdb" : strstr(name, "/aff/") ? "aff" : "nff";
    snprintf(path, sizeof path, "%s/x.%s", folder, kind);
    for (int v = 0; v < VALUES; v++) {
        fflush(stdout);
        pid_t pid = fork();
        if (!pid) {
            child(text, n, values[v], path, v);
            _exit(0);
        }
        int status;
        waitpid(pid, &status, 0);
        if (status)
            fail_msg("%s: %s for `%.*s`%s: %s %d: %s", name, values[v], (int)(at->to - at->from),
                     text + at->from, at->whole_line ? ", each number" : "",
                     WIFSIGNALED(status) ? "signal" : "ends with",
                     WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), at->message);
    }
    unlink(path);
    rmdir(folder);
}

static void test_extremes(void **state) {
    (void)state;
    at = mmap(NULL, sizeof *at, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(at != MAP_FAILED);
    glob_t files = {0};
    assert_int_equal(glob("tests/fuzz/corpus/[anp][fd][bf]/*", 0, NULL, &files), 0);
    assert_int_equal(glob("scenes/one_sphere.nff", GLOB_APPEND, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++)
        try_file(files.gl_pathv[i]);
    printf("# %zu files, %d cases\n", files.gl_pathc, at->cases);
    globfree(&files);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_extremes)};
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
