/* test_frame.c - hashes of frames, frame files, and what a comparison of two frames says
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <string.h>
#include <unistd.h>

#include "core/frame.h"

enum { W = 5, H = 3, N = W * H, PIXEL = 4 * SPH_FRAMES + 20, HEAD = 32 + 8 * SPH_COUNTERS };

static char path[64]; /* of this run's file */

/* Numbers of any length, 0 among them. */
static uint64_t number(int bits) {
    return (uint64_t)between(0, 0x1p53) * 2048 >> (64 - bits + (int)between(0, bits));
}

static struct sph_shot shot(void) {
    struct sph_shot s = {.frame = {W, H, calloc(N, sizeof(struct sph_pixel))}};
    assert_non_null(s.frame.pixels);
    s.errors = (uint32_t)between(0, 1 << SPH_ERRORS);
    for (int i = 0; i < SPH_COUNTERS; i++)
        s.counters.count[i] = number(63);
    for (int i = 0; i < N; i++) {
        struct sph_pixel *p = &s.frame.pixels[i];
        for (int f = 0; f < SPH_FRAMES; f++)
            p->colour[f] = (uint32_t)number(24);
        p->id = (uint32_t)number(31);
        p->visits = (uint32_t)number(31);
        p->texture = uniform() < 0.5 ? SPH_NO_TEXTURE : (uint32_t)number(31);
        p->key = uniform() < 0.5 ? 0 : number(63);
    }
    return s;
}

/* A hash byte by byte, as its definition says. */
static void hash(uint64_t *h, uint64_t value, int bytes) {
    for (; bytes--; value >>= 8)
        *h = (*h ^ (value & 255)) * 1099511628211u;
}

static void test_hashes(void **unused) {
    (void)unused;
    for (int run = 0; run < 300; run++) {
        struct sph_shot s = shot();
        uint64_t all = 14695981039346656037u, seen = all, *both[] = {&all, &seen};
        for (int k = 0; k < 2; k++) {
            hash(both[k], W, 4), hash(both[k], H, 4);
            for (int i = 0; i < N; i++) {
                const struct sph_pixel *p = &s.frame.pixels[i];
                for (int f = 0; f < SPH_FRAMES; f++)
                    hash(both[k], p->colour[f], 4);
                hash(both[k], p->id, 4);
                if (!k) hash(both[k], p->visits, 4);
                if (p->key && p->texture != SPH_NO_TEXTURE)
                    hash(both[k], k ? p->texture >> SPH_LOD_LSB : p->texture, 4);
                hash(both[k], p->key, 8);
            }
        }
        assert_int_equal(sph_frame_hash(&s.frame), all);
        assert_int_equal(sph_frame_picture_hash(&s.frame), seen);
        sph_frame_free(&s.frame);
        assert_null(s.frame.pixels);
    }
}

/* ---- files ---- */
static size_t bytes_of(unsigned char *bytes, size_t most) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t n = fread(bytes, 1, most, file);
    fclose(file);
    return n;
}

static void refused(const unsigned char *bytes, size_t n, const char *part) {
    struct sph_shot back;
    struct sph_error err = {{0}};
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, n, file), n);
    fclose(file);
    if (sph_shot_read(path, &back, &err) != -1) fail_msg("accepted, should say '%s'", part);
    assert_null(back.frame.pixels);
    if (!strstr(err.text, part) || !strstr(err.text, path))
        fail_msg("message '%s' lacks '%s' or the path", err.text, part);
}

/* Little-endian bytes of a number where they are wanted. */
static void is(const unsigned char *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++)
        assert_int_equal(at[i], value >> 8 * i & 255);
}

static void test_file(void **unused) {
    static unsigned char bytes[HEAD + N * PIXEL + 64];
    struct sph_shot s = shot(), back;
    struct sph_error err = {{0}};
    struct sph_frame_difference d;
    (void)unused;
    if (sph_shot_write(&s, path, &err)) fail_msg("%s", err.text);
    if (sph_shot_read(path, &back, &err)) fail_msg("%s", err.text);
    assert_int_equal(sph_shot_compare(&s, &back, 0, &d), 0);
    assert_int_equal(s.errors, back.errors);
    assert_memory_equal(&s.counters, &back.counters, sizeof s.counters);
    assert_memory_equal(s.frame.pixels, back.frame.pixels, N * sizeof *s.frame.pixels);
    sph_frame_free(&back.frame);

    size_t n = bytes_of(bytes, sizeof bytes);
    assert_int_equal(n, HEAD + N * PIXEL + 8);
    const uint32_t head[] = {2, W, H, SPH_FRAMES, SPH_COUNTERS, s.errors};
    assert_memory_equal(bytes, "SPHFRAME", 8);
    for (size_t i = 0; i < sizeof head / sizeof *head; i++)
        is(bytes + 8 + 4 * i, head[i], 4);
    const struct sph_pixel *p = &s.frame.pixels[N - 1];
    const unsigned char *last = bytes + n - 8 - PIXEL;
    is(bytes + HEAD - 8, s.counters.count[SPH_COUNTERS - 1], 8);
    is(last, p->colour[0], 4), is(last + 4 * SPH_FRAMES, p->id, 4);
    is(last + 4 * SPH_FRAMES + 4, p->visits, 4), is(last + 4 * SPH_FRAMES + 8, p->texture, 4);
    is(last + 4 * SPH_FRAMES + 12, p->key, 8);
    uint64_t h = 14695981039346656037u;
    for (size_t i = 0; i < n - 8; i++)
        hash(&h, bytes[i], 1);
    is(bytes + n - 8, h, 8);

    for (size_t at = 0; at < n; at++) { /* any bit of any byte, and any length */
        bytes[at] ^= (unsigned char)(1 << at % 8);
        refused(bytes, n, at < 8 ? "not a frame file" : at < 28 ? "frame" : "checksum");
        bytes[at] ^= (unsigned char)(1 << at % 8);
        refused(bytes, at, at < 8 ? "not a frame file" : at < 32 ? "in its header" : "ends early");
    }
    refused(bytes, n + 1, "is too long");
    for (int field = 0; field < 2; field++) { /* sizes that are none */
        unsigned char *side = bytes + 12 + 4 * field, was = *side;
        *side = 0, refused(bytes, n, "frame size"), *side = was;
        side[2] = 1, *side = 1, refused(bytes, n, "frame size");
        *side = 0, refused(bytes, n, "by its header"), side[2] = 0, *side = was;
    }
    bytes[8] = 3, refused(bytes, n, "version 3 with 3 frames");
    assert_int_equal(sph_shot_write(&s, "/no/such/folder/f", &err), -1);
    assert_int_equal(sph_shot_read("/no/such/file", &back, &err), -1);
    sph_frame_free(&s.frame);
}

/* ---- comparison ---- */
static void says(const struct sph_shot *a, const struct sph_shot *b,
                 const struct sph_frame_difference *d, const char *text) {
    static char said[4096];
    FILE *file = fmemopen(said, sizeof said, "w");
    sph_shot_explain(a, b, d, "left", "right", file);
    fclose(file);
    if (!strstr(said, text)) fail_msg("'%s' is not in: %s", text, said);
}

/* One field of one pixel by one bit: whether work that is ignored is all that differs. */
static void one_field(struct sph_shot *a, struct sph_shot *b, int at, int field, int bit) {
    static const char *const names[] = {"id  ", "visits", "texture", "key"};
    struct sph_pixel *p = &b->frame.pixels[at];
    uint32_t *words[] = {&p->id, &p->visits, &p->texture};
    const int colour = field - 4, work = field == 1 || (field == 2 && bit < SPH_LOD_LSB);
    struct sph_frame_difference d;
    char text[64];
    if (field < 3)
        *words[field] ^= 1u << bit;
    else if (field == 3)
        p->key ^= 1ull << (2 * bit);
    else
        p->colour[colour] ^= 1u << bit % 24;
    assert_int_equal(sph_shot_compare(a, b, 0, &d), 1);
    assert_int_equal(d.pixels, 1);
    assert_int_equal(d.x, at % W);
    assert_int_equal(d.y, at / W);
    assert_int_equal(d.max_colour, field < 4 ? 0 : 1u << bit % 8);
    assert_int_equal(d.counters | d.errors | (uint32_t)d.size_differs, 0);
    snprintf(text, sizeof text, "first at x %d y %d:\n", at % W, at / W);
    says(a, b, &d, "1 of 15 pixels differ"), says(a, b, &d, text);
    says(a, b, &d, "  left              right\n");
    if (field < 4)
        snprintf(text, sizeof text, "  %s", names[field]);
    else
        snprintf(text, sizeof text, "  colour[%d] ", colour);
    says(a, b, &d, text);
    assert_int_equal(sph_shot_compare(a, b, 1, &d), !work);
    assert_int_equal(d.pixels, !work);
    if (field < 3)
        *words[field] ^= 1u << bit;
    else if (field == 3)
        p->key ^= 1ull << (2 * bit);
    else
        p->colour[colour] ^= 1u << bit % 24;
}

static void test_compare(void **unused) {
    static const char *const counters[] = {SPH_COUNTER_NAMES}, *const errors[] = {SPH_ERROR_NAMES};
    struct sph_shot a = shot(), b = a;
    struct sph_frame_difference d;
    char text[128];
    (void)unused;
    b.frame.pixels = malloc(N * sizeof *b.frame.pixels);
    assert_non_null(b.frame.pixels);
    memcpy(b.frame.pixels, a.frame.pixels, N * sizeof *b.frame.pixels);
    assert_int_equal(sph_shot_compare(&a, &b, 0, &d), 0);
    assert_int_equal(d.pixels, 0);
    assert_int_equal(d.x, -1);
    assert_int_equal(d.y, -1);
    for (int field = 0; field < 4 + SPH_FRAMES; field++)
        for (int bit = 0; bit < 32; bit++)
            one_field(&a, &b, (field + 7 * bit) % N, field, bit);

    b.frame.pixels[4].colour[0] ^= 0x0f0000, b.frame.pixels[9].colour[SPH_FRAMES - 1] ^= 0x80;
    b.frame.pixels[11].id ^= 1;
    sph_shot_compare(&a, &b, 1, &d);
    assert_int_equal(d.pixels, 3);
    assert_int_equal(d.y, 0);
    assert_int_equal(d.x, 4);
    assert_int_equal(d.max_colour, 0x80);
    memcpy(b.frame.pixels, a.frame.pixels, N * sizeof *b.frame.pixels);

    for (int i = 0; i < SPH_COUNTERS; i++) {
        b.counters.count[i]++;
        assert_int_equal(sph_shot_compare(&a, &b, 0, &d), sph_counter_both(i));
        assert_int_equal(d.counters, sph_counter_both(i) ? 1u << i : 0);
        assert_int_equal(d.pixels | d.errors, 0);
        snprintf(text, sizeof text, "counter %s: %llu and %llu\n", counters[i],
                 (unsigned long long)a.counters.count[i], (unsigned long long)b.counters.count[i]);
        if (sph_counter_both(i)) says(&a, &b, &d, text);
        assert_int_equal(sph_shot_compare(&a, &b, 1, &d), 0);
        b.counters.count[i]--;
    }
    for (int i = 0; i < SPH_ERRORS; i++) {
        b.errors ^= 1u << i;
        assert_int_equal(sph_shot_compare(&a, &b, 1, &d), 1);
        assert_int_equal(d.errors, 1u << i);
        snprintf(text, sizeof text, "error %s: only in %s\n", errors[i],
                 a.errors >> i & 1 ? "left" : "right");
        says(&a, &b, &d, text);
        b.errors ^= 1u << i;
    }
    for (int side = 0; side < 2; side++) {
        (side ? &b.frame.height : &b.frame.width)[0]--;
        assert_int_equal(sph_shot_compare(&a, &b, 0, &d), 1);
        assert_int_equal(d.size_differs, 1);
        says(&a, &b, &d, side ? "sizes differ: 5x3 and 5x2" : "sizes differ: 5x3 and 4x3");
        (side ? &b.frame.height : &b.frame.width)[0]++;
    }
    sph_frame_free(&a.frame);
    sph_frame_free(&b.frame);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hashes),
        cmocka_unit_test(test_file),
        cmocka_unit_test(test_compare),
    };
    seed(argc, argv);
    snprintf(path, sizeof path, "/tmp/sphaera-frame-%d", (int)getpid());
    int failed = cmocka_run_group_tests_name("frame", tests, NULL, NULL);
    unlink(path);
    return failed;
}
