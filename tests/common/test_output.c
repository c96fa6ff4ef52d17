/* test_output.c - outputs are whole, whoever else writes the same one; see common/file.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/file.h"

enum { TIMES = 400, SIZE = 20000 };
static char folder[64], path[80];

static int make_folder(void **state) {
    (void)state;
    strcpy(folder, "/tmp/test_output.XXXXXX");
    if (!mkdtemp(folder)) return -1;
    snprintf(path, sizeof path, "%s/out", folder);
    return 0;
}

static int remove_folder(void **state) {
    (void)state;
    unlink(path);
    return rmdir(folder); /* and so nothing is left in it */
}

static int write_whole(char letter) {
    struct sph_output out;
    struct sph_error err = {""};
    if (sph_output_open(&out, path, &err)) return -1;
    for (int i = 0; i < SIZE; i++)
        putc(letter, out.file);
    return sph_output_close(&out, 0, &err);
}

/* How many of SIZE letters the file has, all alike; 0 if they are not. */
static int letters(void) {
    static char text[2 * SIZE];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t n = fread(text, 1, sizeof text, file);
    fclose(file);
    for (size_t i = 1; i < n; i++)
        if (text[i] != text[0]) return 0;
    return (int)n;
}

static void *write_often(void *letter) {
    uintptr_t failed = 0;
    for (int i = 0; i < TIMES; i++)
        failed += write_whole(*(const char *)letter) != 0;
    return (void *)failed;
}

/* Both threads have one number of a process. */
static void two_threads_write_one_file(void **state) {
    (void)state;
    pthread_t thread;
    void *failed;
    assert_int_equal(write_whole('c'), 0);
    assert_int_equal(pthread_create(&thread, NULL, write_often, "a"), 0);
    for (int i = 0; i < TIMES; i++) {
        assert_int_equal(write_whole('b'), 0);
        assert_int_equal(letters(), SIZE);
    }
    pthread_join(thread, &failed);
    assert_null(failed);
}

/* Two containers have processes of one number: no name is made of it. A link that stands at a name
 * is not followed: each name is new. */
static void names_are_new(void **state) {
    (void)state;
    char one[128], two[128];
    int first = sph_output_beside(one, sizeof one, path, "tmp");
    int second = sph_output_beside(two, sizeof two, path, "tmp");
    assert_true(first >= 0 && second >= 0 && strcmp(one, two) != 0);
    close(first), close(second);
    unlink(one), unlink(two);
    sph_output_forget(one), sph_output_forget(two);
    assert_int_equal(sph_output_beside(one, 20, path, "tmp"), -1);
}

static void old_names_are_not_followed(void **state) {
    (void)state;
    char link[128], victim[96];
    snprintf(victim, sizeof victim, "%s/victim", folder);
    snprintf(link, sizeof link, "%s.%ld.tmp", path, (long)getpid());
    FILE *file = fopen(victim, "wb");
    assert_non_null(file);
    fclose(file);
    assert_int_equal(symlink(victim, link), 0);
    assert_int_equal(write_whole('d'), 0);
    struct stat st;
    assert_int_equal(stat(victim, &st), 0);
    assert_int_equal(st.st_size, 0);
    unlink(link), unlink(victim);
}

static void rights_are_those_of_a_new_file(void **state) {
    (void)state;
    struct stat st;
    mode_t old = umask(027);
    assert_int_equal(write_whole('e'), 0);
    umask(old);
    assert_int_equal(stat(path, &st), 0);
    assert_int_equal(st.st_mode & 0777, 0640);
}

static void a_failed_one_leaves_nothing(void **state) {
    (void)state;
    struct sph_output out;
    struct sph_error err = {""};
    assert_int_equal(sph_output_open(&out, path, &err), 0);
    assert_int_equal(sph_output_close(&out, 1, &err), -1);
    assert_int_equal(access(out.temporary, F_OK), -1);
}

/* The C library's, unless it is to fail. */
static int no_stream;
FILE *fdopen(int fd, const char *mode) {
    FILE *(*real)(int, const char *);
    void *found = dlsym(RTLD_NEXT, "fdopen");
    memcpy(&real, &found, sizeof real);
    if (no_stream) return errno = ENOMEM, NULL;
    return real(fd, mode);
}

/* Files of the folder but . and .. */
static int files(void) {
    DIR *d = opendir(folder);
    int n = 0;
    assert_non_null(d);
    while (readdir(d))
        n++;
    closedir(d);
    return n - 2;
}

static void one_without_a_stream_leaves_nothing(void **state) {
    (void)state;
    struct sph_output out;
    struct sph_error err = {""};
    int before = files(), lowest = dup(0);
    close(lowest);
    no_stream = 1;
    assert_int_equal(sph_output_open(&out, path, &err), -1);
    no_stream = 0;
    assert_non_null(strstr(err.text, strerror(ENOMEM)));
    assert_int_equal(files(), before);
    int now = dup(0);
    close(now);
    assert_int_equal(now, lowest); /* no descriptor is left open */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_threads_write_one_file),
        cmocka_unit_test(names_are_new),
        cmocka_unit_test(old_names_are_not_followed),
        cmocka_unit_test(a_failed_one_leaves_nothing),
        cmocka_unit_test(one_without_a_stream_leaves_nothing),
        cmocka_unit_test(rights_are_those_of_a_new_file),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
