/* test_extremes.c - numbers as small, large and alike as files can have: an answer within a second
 * SPDX-License-Identifier: Apache-2.0
 *
 * Each number of each file below takes each value, one at a time, then all numbers of a line do;
 * then all lengths of an NFF file are multiplied by it. The file is read, built as `sphaera render`
 * does, described as `sphaera info` does, and drawn: there is a frame, or a message that begins
 * with the file's name. Without ALL=1 each number takes every twelfth value, another in each place.
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

#include "trial/choose.h"
#include "common/number.h"
#include "render/render.h"
#include "number.h"
#include "scene/import.h"
#include "validate/describe.h"

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
enum { ONE, LINE, LENGTHS };
static const char *const ways[] = {"", ", each number", ", times each length"};

/* What the child is at, for whoever finds it dead. */
static struct {
    size_t from, to; /* bytes of the file that are replaced */
    int way, cases;
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

/* The text with the lengths of all its lines multiplied. */
static size_t multiplied(const char *text, const char *value, char *out) {
    static const char *const lengths[] = {"from", "at", "hither", "l", "s", "c", "plane", "move"};
    double factor = 1, number;
    size_t used = 0;
    int is_length = 0;
    char word[64];
    sph_parse_number(value, &factor); /* it is read, if it is too large, too */
    for (int n; *text; text += n) {
        n = (int)strcspn(text, " \n");
        if (n == 0) n = 1;
        int starts = !used || out[used - 1] == '\n';
        snprintf(word, sizeof word, "%.*s", n, text);
        int is_number = !sph_parse_number(word, &number);
        if (starts && n) {
            is_length = is_number; /* a point of a polygon */
            for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
                is_length |= !strcmp(lengths[i], word);
        }
        used += (size_t)(is_length && is_number ? sprintf(out + used, "%.17g", number * factor)
                                                : sprintf(out + used, "%s", word));
    }
    return used;
}

static int read_scene(const char *path, struct sph_scene *scene, struct sph_error *err) {
    const struct sph_read_options options = {.skip_unsupported = 1, .at = 1};
    return strstr(path, ".pdb") ? sph_import(path, SPH_FILE_PDB, NULL, scene, err)
                                : sph_scene_read(path, &options, scene, err);
}

/* Reads, builds, draws; 0 if what it says is no message with the file's name. */
static int answered(const char *path) {
    static struct sph_build_report report;
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_error_bound bound = {SPH_ERROR_BOUND_PIXELS, SPH_ERROR_BOUND_PSNR};
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
        if (!sph_build_kept(&scene, &o, 1, &bound, &choice, &m, &report, &err)) {
            FILE *nowhere = fopen("/dev/null", "w");
            if (!nowhere) _exit(3);
            sph_machine_describe(&m, nowhere);
            fclose(nowhere);
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

static void answer(const char *path, const char *text, size_t n) {
    FILE *file = fopen(path, "wb");
    if (!file) _exit(3);
    fwrite(text, 1, n, file);
    fclose(file);
    at->cases++;
    if (!answered(path)) _exit(2);
}

/* Puts the value for each number of the text, and for those of each line. */
static void child(const char *text, size_t n, const char *value, const char *path, int turn) {
    int columns = strstr(path, ".pdb") != NULL;
    char *out = malloc(n * 25 + 64);
    int all = getenv("ALL") != NULL, of = all ? 1 : SANITIZED ? 48 : 12;
    for (int way = ONE; way <= LINE; way++) {
        at->way = way;
        for (size_t i = 0; i < n; i++) {
            int starts = way == LINE ? !i || text[i - 1] == '\n'
                                     : isdigit((unsigned char)text[i]) || strchr("+-.", text[i]);
            if (way == ONE && i && !isspace((unsigned char)text[i - 1])) starts = 0;
            if (!starts || turn++ % of) continue;
            size_t end = i;
            while (end < n &&
                   (way == LINE ? text[end] != '\n' : !isspace((unsigned char)text[end])))
                end++;
            at->from = i, at->to = end;
            answer(path, out, replaced(text, n, value, columns, out));
            i = end - (end > i);
        }
    }
    at->way = LENGTHS;
    at->from = at->to = 0;
    if (strstr(path, ".nff")) answer(path, out, multiplied(text, value, out));
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
                     text + at->from, ways[at->way], WIFSIGNALED(status) ? "signal" : "ends with",
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
