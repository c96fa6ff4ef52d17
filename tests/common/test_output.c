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
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/resource.h>
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

/* ---- the C library's calls, unless they are to fail ---- */
static const char *fails;  /* the one that does */
static int cause, numbers; /* with which errno; draws of a number that give the same one */
enum { NUMBER = 7 };

/* Sets `real` of a function to the next one of its name; ends it if it is to fail. */
#define REAL(name, failed)                                                                         \
    void *found = dlsym(RTLD_NEXT, #name);                                                         \
    memcpy(&real, &found, sizeof real);                                                            \
    if (fails && !strcmp(fails, #name)) return errno = cause, failed

int open(const char *name, int flags, ...) {
    int (*real)(const char *, int, ...);
    va_list more;
    va_start(more, flags);
    mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
    va_end(more);
    REAL(open, -1);
    return real(name, flags, mode);
}

FILE *fdopen(int fd, const char *mode) {
    FILE *(*real)(int, const char *);
    REAL(fdopen, NULL);
    return real(fd, mode);
}

int fsync(int fd) {
    int (*real)(int);
    REAL(fsync, -1);
    return real(fd);
}

int fclose(FILE *file) {
    int (*real)(FILE *);
    void *close_it = dlsym(RTLD_NEXT, "fclose");
    memcpy(&real, &close_it, sizeof real);
    int rc = real(file); /* one that fails closes, too */
    return fails && !strcmp(fails, "fclose") ? errno = cause, EOF : rc;
}

int rename(const char *from, const char *to) {
    int (*real)(const char *, const char *);
    REAL(rename, -1);
    return real(from, to);
}

ssize_t getrandom(void *bytes, size_t n, unsigned flags) {
    ssize_t (*real)(void *, size_t, unsigned);
    REAL(getrandom, -1);
    if (numbers <= 0) return real(bytes, n, flags);
    numbers--;
    memset(bytes, 0, n);
    *(unsigned char *)bytes = NUMBER;
    return (ssize_t)n;
}

/* Files of the folder. */
static int files(void) {
    DIR *d = opendir(folder);
    int n = -2; /* . and .. */
    assert_non_null(d);
    while (readdir(d))
        n++;
    closedir(d);
    return n;
}

static int lowest_descriptor(void) {
    int fd = dup(0);
    close(fd);
    return fd;
}

/* Two containers have processes of one number, which may even draw the same one. What stands at a
 * temporary name, a link or a file, is not followed, opened, or removed. */
static void names_are_new(void **state) {
    (void)state;
    char planted[128], victim[96];
    struct stat st;
    snprintf(victim, sizeof victim, "%s/victim", folder);
    snprintf(planted, sizeof planted, "%s.%016x.tmp", path, NUMBER);
    FILE *file = fopen(victim, "wb");
    assert_non_null(file);
    fclose(file);
    for (int hard = 0; hard < 2; hard++) {
        assert_int_equal(hard ? link(victim, planted) : symlink(victim, planted), 0);
        numbers = 3;
        assert_int_equal(write_whole('d'), 0);
        assert_int_equal(numbers, 0); /* the planted name was tried */
        assert_int_equal(letters(), SIZE);
        assert_int_equal(stat(victim, &st), 0);
        assert_int_equal(st.st_size, 0);
        assert_int_equal(unlink(planted), 0);
    }
    unlink(victim);
    struct sph_output one, two;
    assert_int_equal(sph_output_open(&one, path, NULL), 0);
    assert_int_equal(sph_output_open(&two, path, NULL), 0);
    assert_string_not_equal(one.temporary, two.temporary);
    sph_output_close(&one, 1, NULL), sph_output_close(&two, 1, NULL);
}

/* One that is written by its name, of the ending that its writer goes by. */
static void another_may_write_it(void **state) {
    (void)state;
    struct sph_output out;
    struct sph_error err = {""};
    assert_int_equal(sph_output_open_named(&out, path, "tmp.gif", &err), 0);
    assert_string_equal(out.temporary + strlen(out.temporary) - 8, ".tmp.gif");
    FILE *file = fopen(out.temporary, "wb");
    assert_non_null(file);
    for (int i = 0; i < SIZE; i++)
        putc('f', file);
    fclose(file);
    assert_int_equal(sph_output_close(&out, 0, &err), 0);
    assert_int_equal(letters(), SIZE);
    assert_int_equal(sph_output_open_named(&out, "/dev/null", "tmp.gif", &err), -1);
    assert_string_equal(err.text, "/dev/null: is a device, not a file");
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

/* Each call of the system that fails is told, by the file and the cause; what was there before is
 * whole, and nothing else is there, no file, no open descriptor. */
static void each_failed_call_is_told(void **state) {
    (void)state;
    static const struct {
        const char *call;
        int cause, told; /* 0: none */
    } rows[] = {
        {"getrandom", ENOSYS, ENOSYS}, {"open", EACCES, EACCES}, /* a folder that takes no file */
        {"open", EEXIST, EEXIST},                                /* of whatever name */
        {"fdopen", ENOMEM, ENOMEM},    {"write", EFBIG, EFBIG},
        {"fsync", EIO, EIO},           {"fsync", EINVAL, 0}, /* there is nothing to wait for */
        {"fclose", EDQUOT, EDQUOT},    {"rename", EPERM, EPERM},
    };
    const struct rlimit small = {SIZE / 2, RLIM_INFINITY}, any = {RLIM_INFINITY, RLIM_INFINITY};
    assert_int_equal(write_whole('a'), 0);
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sph_output out;
        struct sph_error err = {""};
        int before = files(), lowest = lowest_descriptor(), rc;
        fails = rows[i].call, cause = rows[i].cause;
        if (!strcmp(fails, "write")) setrlimit(RLIMIT_FSIZE, &small);
        rc = sph_output_open(&out, path, &err);
        for (int k = 0; k < SIZE && !rc; k++)
            putc(rows[i].told ? 'z' : 'a', out.file);
        if (!rc) rc = sph_output_close(&out, 0, &err);
        setrlimit(RLIMIT_FSIZE, &any);
        fails = NULL;
        char told[256] = "";
        if (rows[i].told) snprintf(told, sizeof told, "%s: %s", path, strerror(rows[i].told));
        if (rc != (rows[i].told ? -1 : 0) || strcmp(err.text, told) != 0)
            fail_msg("%s: %d, says '%s', not '%s'", rows[i].call, rc, err.text, told);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        assert_int_equal(getc(file), 'a');
        fclose(file);
        assert_int_equal(letters(), SIZE);
        assert_int_equal(files(), before);
        assert_int_equal(lowest_descriptor(), lowest);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_threads_write_one_file),
        cmocka_unit_test(names_are_new),
        cmocka_unit_test(another_may_write_it),
        cmocka_unit_test(a_failed_one_leaves_nothing),
        cmocka_unit_test(each_failed_call_is_told),
        cmocka_unit_test(rights_are_those_of_a_new_file),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
