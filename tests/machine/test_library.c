/* test_library.c - functions of the library that can fail refuse NULL by the argument's name
 * SPDX-License-Identifier: Apache-2.0
 */
#include "sphaera/sphaera.h"

/* clang-format off: cmocka.h needs these before it */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
/* clang-format on */

#define REFUSED(name, call)                                                                        \
    do {                                                                                           \
        sphaera_error error = {""};                                                                \
        assert_int_equal(call, -1);                                                                \
        assert_string_equal(error.text, name " is NULL");                                          \
    } while (0)

static const char text[] = "v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\n"
                           "resolution 8 4\nf 1 0 0 1 0 0 0 1\ns 0 0 0 1\n";

static void test_null(void **unused) {
    sphaera_scene *s;
    sphaera_machine *m;
    sphaera_frame *f;
    sphaera_hit hit;
    const double v[3] = {0, 0, -1};
    uint8_t rgb[3 * 8 * 4];
    size_t n = sizeof text - 1;
    (void)unused;
    assert_int_equal(sphaera_scene_parse(text, n, "s", 0, &s, NULL), 0);
    assert_int_equal(sphaera_build(s, NULL, &m, NULL), 0);
    assert_int_equal(sphaera_render(m, 1, &f, NULL), 0);
    REFUSED("path", sphaera_scene_read(NULL, 0, &s, &error));
    REFUSED("scene", sphaera_scene_read("s", 0, NULL, &error));
    REFUSED("text", sphaera_scene_parse(NULL, n, "s", 0, &s, &error));
    REFUSED("scene", sphaera_scene_parse(text, n, "s", 0, NULL, &error));
    REFUSED("name", sphaera_scene_parse(text, n, NULL, 0, &s, &error));
    REFUSED("scene", sphaera_build(NULL, NULL, &m, &error));
    REFUSED("machine", sphaera_build(s, NULL, NULL, &error));
    REFUSED("path", sphaera_machine_read(NULL, &m, &error));
    REFUSED("machine", sphaera_machine_read("m", NULL, &error));
    REFUSED("machine", sphaera_machine_write(NULL, "m", &error));
    REFUSED("path", sphaera_machine_write(m, NULL, &error));
    REFUSED("machine", sphaera_render(NULL, 1, &f, &error));
    REFUSED("frame", sphaera_render(m, 1, NULL, &error));
    REFUSED("frame", sphaera_frame_write(NULL, "f.png", &error));
    REFUSED("path", sphaera_frame_write(f, NULL, &error));
    REFUSED("machine", sphaera_trace(NULL, v, v, &hit, &error));
    REFUSED("origin", sphaera_trace(m, NULL, v, &hit, &error));
    REFUSED("direction", sphaera_trace(m, v, NULL, &hit, &error));
    REFUSED("hit", sphaera_trace(m, v, v, NULL, &error));
    assert_int_equal(sphaera_frame_rgb(NULL, 0, rgb), -1);
    assert_int_equal(sphaera_frame_rgb(f, 0, NULL), -1);
    assert_int_equal(sphaera_counter_find(NULL), -1);
    assert_int_equal(sphaera_scene_read(NULL, 0, &s, NULL), -1); /* nobody asks why */
    sphaera_frame_free(f);
    sphaera_machine_free(m);
    sphaera_scene_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_null)};
    return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
