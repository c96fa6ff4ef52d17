/* test_driver.c - what the driver refuses, by name, before it writes anything
 * SPDX-License-Identifier: Apache-2.0
 *
 * The block is an array of registers; a machine file is made of its fields. Each row changes one
 * thing of a block and a machine that go together.
 */
#include "../../driver/sphaera.c"

#include <setjmp.h>
#include <stdarg.h>
#include <string.h>
#include <cmocka.h>

enum { LINES = 3, BYTES = SPHAERA_HEADER_LEAST + 4 * SPHAERA_MACHINE_REGISTERS };

static const uint32_t PROFILE = 0x1234567;

struct block {
    uint32_t words[1024];
    int writes, puts;
    uint32_t polls; /* reads of STATUS */
    uint32_t after; /* STATUS behind a TAKE */
    uint64_t address;
    uint32_t count;
};

static uint32_t reads(void *user, uint32_t offset) {
    struct block *b = user;
    b->polls += offset == SPHAERA_STATUS;
    return b->words[offset / 4];
}

static void writes(void *user, uint32_t offset, uint32_t value) {
    struct block *b = user;
    b->words[offset / 4] = value;
    b->writes++;
    if (offset == SPHAERA_CONTROL && value & SPHAERA_CONTROL_TAKE)
        b->words[SPHAERA_STATUS / 4] = b->after;
}

static void puts_(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
    struct block *b = user;
    (void)bytes;
    b->puts++;
    b->address = address;
    b->count = count;
}

static uint32_t parts(uint32_t depth, uint32_t lights, uint32_t cones) {
    return depth << SPHAERA_CORE_PARTS_DEPTH_LSB | lights << SPHAERA_CORE_PARTS_LIGHTS_LSB |
           cones << SPHAERA_CORE_PARTS_CONES_LSB;
}

static void block(struct block *b, uint32_t has, uint32_t bits) {
    memset(b, 0, sizeof *b);
    b->words[SPHAERA_ID / 4] = SPHAERA_ID_RESET;
    b->words[SPHAERA_VERSION / 4] = SPHAERA_VERSION_RESET;
    b->words[SPHAERA_CORE_PROFILE / 4] = PROFILE;
    b->words[SPHAERA_CORE_EFFECTS / 4] = 3;
    b->words[SPHAERA_CORE_PARTS / 4] = has;
    b->words[SPHAERA_CORE_BUS / 4] = 64 | bits << SPHAERA_CORE_BUS_ADDR_LSB;
}

static void opened(struct sphaera *s, struct block *b, uint32_t has, uint32_t bits) {
    block(b, has, bits);
    const struct sphaera_bus bus = {reads, writes, puts_, b};
    assert_int_equal(sphaera_open(s, &bus), SPHAERA_OK);
    b->writes = 0;
}

static void word(uint8_t *at, uint32_t value) {
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

/* A machine file of LINES lines; two registers besides profile and effects. */
static uint32_t made(uint8_t *file, uint32_t reg, uint32_t value, uint32_t other, uint32_t its) {
    memset(file, 0, BYTES);
    memcpy(file, "SPHAERA1", 8);
    word(file + SPHAERA_AT_VERSION, SPHAERA_FILE_VERSION);
    word(file + SPHAERA_AT_HEADER, BYTES);
    word(file + SPHAERA_AT_REGISTERS, SPHAERA_MACHINE_REGISTERS);
    word(file + SPHAERA_AT_LINES, LINES);
    uint8_t *registers = file + SPHAERA_HEADER_LEAST;
    word(registers + 4 * SPHAERA_REG_PROFILE, PROFILE);
    word(registers + 4 * SPHAERA_REG_EFFECTS, 1);
    word(registers + 4 * SPHAERA_REG_TREE, SPHAERA_TREE_BALANCED);
    word(registers + 4 * other, its);
    word(registers + 4 * reg, value);
    return BYTES + LINES * SPHAERA_LINE_BYTES + SPHAERA_CHECKSUM_BYTES;
}

#define SIZE ((uint64_t)LINES * SPHAERA_LINE_BYTES)
#define REG(name) SPHAERA_REG_##name
#define PART(name) SPHAERA_CORE_PARTS_##name

static void load(void **state) {
    (void)state;
    const uint32_t none = REG(FRAME_W); /* a register for the host */
    const uint32_t all = parts(2, 3, 4);
    const struct {
        uint32_t has, bits, reg, value, other, its;
        uint64_t base;
        int result;
    } rows[] = {
        /* as much as the core has, and less */
        {all, 32, REG(MAX_DEPTH), 2, REG(N_LIGHTS), 3, 0x1000, SPHAERA_OK},
        {all, 32, none, 1, none, 1, 0x1000, SPHAERA_OK},
        /* one more than it has */
        {all, 32, REG(MAX_DEPTH), 3, none, 0, 0x1000, SPHAERA_TOO_DEEP},
        {all, 32, REG(N_LIGHTS), 4, none, 0, 0x1000, SPHAERA_TOO_MANY_LIGHTS},
        {all, 32, REG(EFFECTS), 4, none, 0, 0x1000, SPHAERA_TOO_MUCH},
        {all, 32, REG(PROFILE), 5, none, 0, 0x1000, SPHAERA_OTHER_WIDTHS},
        /* each kind of tree on a core of each */
        {all, 32, REG(TREE), SPHAERA_TREE_BIH, none, 0, 0x1000, SPHAERA_OTHER_TREE},
        {all, 32, REG(TREE), SPHAERA_TREE_BRUTE, none, 0, 0x1000, SPHAERA_OTHER_TREE},
        {all, 32, REG(TREE), SPHAERA_TREE_BOX4, none, 0, 0x1000, SPHAERA_OTHER_TREE},
        {all | PART(ACCEL), 32, none, 0, none, 0, 0x1000, SPHAERA_OTHER_TREE},
        {all | PART(ACCEL), 32, REG(TREE), SPHAERA_TREE_BRUTE, none, 0, 0x1000, SPHAERA_OK},
        {all | PART(BOXES), 32, REG(TREE), SPHAERA_TREE_BOX4, none, 0, 0x1000, SPHAERA_OK},
        {all | PART(BOXES), 32, REG(TREE), SPHAERA_TREE_BIH, none, 0, 0x1000, SPHAERA_OTHER_TREE},
        /* ways of background separation; cones are counted in their own way alone */
        {all, 32, REG(BG_MODE), 1, none, 0, 0x1000, SPHAERA_NO_BACKGROUND},
        {all | PART(RECT), 32, REG(BG_MODE), 1, none, 0, 0x1000, SPHAERA_OK},
        {all | PART(RECT), 32, REG(BG_MODE), 2, none, 0, 0x1000, SPHAERA_NO_BACKGROUND},
        {all | PART(SPANS), 32, REG(BG_MODE), 2, REG(BG_COUNT), 9, 0x1000, SPHAERA_OK},
        {all, 32, REG(BG_MODE), 3, REG(BG_COUNT), 4, 0x1000, SPHAERA_OK},
        {all, 32, REG(BG_MODE), 3, REG(BG_COUNT), 5, 0x1000, SPHAERA_NO_BACKGROUND},
        {parts(2, 3, 0), 32, REG(BG_MODE), 3, none, 0, 0x1000, SPHAERA_NO_BACKGROUND},
        {all, 32, REG(COARSE), 2, none, 0, 0x1000, SPHAERA_OTHER_LEVELS},
        /* the end of the address space: the last page fits, the next one does not */
        {all, 32, none, 0, none, 0, 0x123, SPHAERA_MISPLACED},
        {all, 32, none, 0, none, 0, 0xfffff000, SPHAERA_OK},
        {all, 32, none, 0, none, 0, 0x100000000, SPHAERA_BEYOND},
        {all, 40, none, 0, none, 0, 0x100000000, SPHAERA_OK},
        {all, 40, none, 0, none, 0, 0xfffffff000, SPHAERA_OK},
        {all, 40, none, 0, none, 0, 0x10000000000, SPHAERA_BEYOND},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct block b;
        struct sphaera s;
        uint8_t file[BYTES + SIZE + SPHAERA_CHECKSUM_BYTES] = {0};
        opened(&s, &b, rows[i].has, rows[i].bits);
        const uint32_t bytes = made(file, rows[i].reg, rows[i].value, rows[i].other, rows[i].its);
        const int result = sphaera_load(&s, file, bytes, rows[i].base);
        if (result != rows[i].result)
            fail_msg("row %zu: %s, not: %s", i, sphaera_text(result), sphaera_text(rows[i].result));
        if (result) {
            assert_int_equal(b.writes + b.puts, 0);
            continue;
        }
        assert_int_equal(b.address, rows[i].base);
        assert_int_equal(b.count, SIZE);
        assert_int_equal(b.words[SPHAERA_SCENE_BASE / 4], rows[i].base & 0xffffffff);
        assert_int_equal(b.words[SPHAERA_ADDRESS_HIGH / 4] >> SPHAERA_ADDRESS_HIGH_SCENE_LSB,
                         rows[i].base >> 32);
    }
}

/* A block of another major version, or none, is left alone; one of another minor version is not. */
static void versions(void **state) {
    (void)state;
    const uint32_t minor = ~(uint32_t)SPHAERA_VERSION_MAJOR;
    const struct {
        uint32_t id, version; /* changed bits */
        int result;
    } rows[] = {
        {0, 0, SPHAERA_OK},
        {0, minor & -minor, SPHAERA_OK},
        {0, minor, SPHAERA_OK},
        {0, SPHAERA_VERSION_MAJOR & -(uint32_t)SPHAERA_VERSION_MAJOR, SPHAERA_ABSENT},
        {0, (uint32_t)SPHAERA_VERSION_MAJOR & ~((uint32_t)SPHAERA_VERSION_MAJOR >> 1),
         SPHAERA_ABSENT},
        {1, 0, SPHAERA_ABSENT},
        {0x80000000, 0, SPHAERA_ABSENT},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct block b;
        struct sphaera s;
        const struct sphaera_bus bus = {reads, writes, puts_, &b};
        block(&b, 0, 32);
        b.words[SPHAERA_ID / 4] ^= rows[i].id;
        b.words[SPHAERA_VERSION / 4] ^= rows[i].version;
        const int result = sphaera_open(&s, &bus);
        if (result != rows[i].result) fail_msg("row %zu: %s", i, sphaera_text(result));
        if (result) assert_int_equal(b.writes, 0);
    }
}

/* Bytes that are no machine file, of this version and size, write nothing. */
static void files(void **state) {
    (void)state;
    const struct {
        int at;   /* of a byte whose lowest bit changes; -1: none */
        int more; /* bytes */
        int result;
    } rows[] = {
        {-1, 0, SPHAERA_OK},
        {0, 0, SPHAERA_BAD_FILE},                                    /* magic */
        {7, 0, SPHAERA_BAD_FILE},                                    /* its last letter */
        {SPHAERA_AT_VERSION, 0, SPHAERA_BAD_FILE},                   /* another version */
        {SPHAERA_AT_HEADER, 0, SPHAERA_BAD_FILE},                    /* another header */
        {SPHAERA_AT_REGISTERS, 0, SPHAERA_BAD_FILE},                 /* other registers */
        {SPHAERA_AT_LINES, 0, SPHAERA_BAD_FILE},                     /* a line less than there is */
        {SPHAERA_AT_LINES + 3, 0, SPHAERA_BAD_FILE},                 /* more than any memory */
        {-1, 1, SPHAERA_BAD_FILE},                                   /* a byte behind its end */
        {-1, SPHAERA_LINE_BYTES, SPHAERA_BAD_FILE},                  /* a line behind its end */
        {-1, -1, SPHAERA_BAD_FILE},                                  /* without its last byte */
        {-1, -SPHAERA_LINE_BYTES, SPHAERA_BAD_FILE},                 /* without its last line */
        {-1, -(int)SIZE - SPHAERA_CHECKSUM_BYTES, SPHAERA_BAD_FILE}, /* a header alone */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct block b;
        struct sphaera s;
        uint8_t file[BYTES + SIZE + SPHAERA_CHECKSUM_BYTES + SPHAERA_LINE_BYTES] = {0};
        opened(&s, &b, 0, 32);
        const uint32_t bytes = made(file, REG(FRAME_W), 1, REG(FRAME_H), 1);
        if (rows[i].at >= 0) file[rows[i].at] ^= 1;
        const int result = sphaera_load(&s, file, bytes + (uint32_t)rows[i].more, 0x1000);
        if (result != rows[i].result) fail_msg("row %zu: %s", i, sphaera_text(result));
        if (result) assert_int_equal(b.writes + b.puts, 0);
    }
}

/* Both words of each counter, low and high. */
static void counters(void **state) {
    (void)state;
    struct block b;
    struct sphaera s;
    uint64_t counts[SPHAERA_COUNTS];
    opened(&s, &b, 0, 32);
    for (uint32_t i = 0; i < 2 * SPHAERA_COUNTS; i++)
        b.words[SPHAERA_COUNTERS / 4 + i] = 0x80000001 + 2 * i;
    sphaera_counters(&s, counts);
    for (uint32_t i = 0; i < SPHAERA_COUNTS; i++)
        assert_true(counts[i] == (0x80000001 + 4ull * i) + ((0x80000003 + 4ull * i) << 32));
}

/* The end of a machine's memory, not its beginning alone. */
static void load_end(void **state) {
    (void)state;
    struct block b;
    struct sphaera s;
    opened(&s, &b, 0, 32);
    assert_false(beyond(&s, 0x100000000 - SIZE, SIZE));
    assert_true(beyond(&s, 0x100000000 - SIZE + 1, SIZE));
    assert_true(beyond(&s, UINT64_MAX, SIZE));
}

static void store(void **state) {
    (void)state;
    const struct {
        uint64_t frames[3];
        uint32_t stride, bits;
        int result;
    } rows[] = {
        {{0, 0x40, 0xffffff00}, 256, 32, SPHAERA_OK},
        {{0, 0x40, 0xffffff00}, 288, 32, SPHAERA_BEYOND}, /* its first row */
        {{0, 0x20, 0x80}, 256, 32, SPHAERA_MISPLACED},
        {{0, 0x40, 0x80}, 16, 32, SPHAERA_MISPLACED},
        {{0x5600000000, 0x4000000040, 0xff00000080}, 256, 40, SPHAERA_OK},
        {{0x5600000000, 0x40, 0x80}, 256, 32, SPHAERA_BEYOND},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct block b;
        struct sphaera s;
        opened(&s, &b, 0, rows[i].bits);
        if (rows[i].bits > 32) b.words[SPHAERA_ADDRESS_HIGH / 4] = 0x12345678;
        assert_int_equal(sphaera_store(&s, rows[i].frames, rows[i].stride, 0), rows[i].result);
        if (rows[i].result) {
            assert_int_equal(b.writes, 0);
            continue;
        }
        const uint32_t low[3] = {b.words[SPHAERA_FRAME0 / 4], b.words[SPHAERA_FRAME1 / 4],
                                 b.words[SPHAERA_FRAME2 / 4]};
        const uint32_t high = b.words[SPHAERA_ADDRESS_HIGH / 4];
        for (int k = 0; k < 3; k++)
            assert_int_equal(low[k] | (uint64_t)(high >> 8 * k & 255) << 32, rows[i].frames[k]);
        assert_int_equal(high >> 24, rows[i].bits > 32 ? 0x12 : 0); /* the scene's stay */
    }
}

/* Looks once, and so many times more: 0 does not mean for ever. */
static void late(void **state) {
    (void)state;
    for (uint32_t polls = 0; polls < 3; polls++) {
        struct block b;
        struct sphaera s;
        opened(&s, &b, 0, 32);
        b.words[SPHAERA_STATUS / 4] = SPHAERA_STATUS_BUSY | SPHAERA_STATUS_DRAINING;
        b.polls = 0;
        assert_int_equal(sphaera_wait(&s, polls), SPHAERA_LATE);
        assert_int_equal(b.polls, polls + 1);
        assert_int_equal(sphaera_reset(&s, 0, polls), SPHAERA_LATE);
        assert_int_equal(b.polls, 2 * (polls + 1));
    }
}

/* A frame that had errors failed; what is shown is so behind the take, not before it. */
static void ends(void **state) {
    (void)state;
    struct block b;
    struct sphaera s;
    unsigned frame;
    opened(&s, &b, 0, 32);
    assert_int_equal(sphaera_wait(&s, 0), SPHAERA_OK);
    b.words[SPHAERA_ERRORS / 4] = 1;
    assert_int_equal(sphaera_wait(&s, 0), SPHAERA_FAILED);
    b.after = SPHAERA_STATUS_VALID | 2u << SPHAERA_STATUS_SHOWN_LSB;
    assert_int_equal(sphaera_take(&s, &frame), SPHAERA_OK);
    assert_int_equal(frame, 2);
    b.after = 0;
    assert_int_equal(sphaera_take(&s, &frame), SPHAERA_BUSY);
}

/* Each field of a mode in its register, and each bit. */
static void video(void **state) {
    (void)state;
    struct block b;
    struct sphaera s;
    opened(&s, &b, 0, 32);
    for (int bits = 0; bits < 8; bits++) {
        const struct sphaera_mode mode = {.h_active = 640,
                                          .h_front = 16,
                                          .h_sync = 96,
                                          .h_back = 48,
                                          .v_active = 480,
                                          .v_front = 10,
                                          .v_sync = 2,
                                          .v_back = 33,
                                          .h_pol = bits & 1,
                                          .v_pol = bits >> 1 & 1,
                                          .doubled = (uint8_t)(bits >> 2)};
        sphaera_video(&s, &mode);
        assert_int_equal(b.words[SPHAERA_VIDEO / 4], SPHAERA_VIDEO_ENABLE |
                                                         (bits & 1 ? SPHAERA_VIDEO_H_POL : 0) |
                                                         (bits & 2 ? SPHAERA_VIDEO_V_POL : 0) |
                                                         (bits & 4 ? SPHAERA_VIDEO_DOUBLE : 0));
        assert_int_equal(b.words[SPHAERA_VIDEO_H_ACTIVE / 4], 640 | 16 << 16);
        assert_int_equal(b.words[SPHAERA_VIDEO_H_SYNC / 4], 96 | 48 << 16);
        assert_int_equal(b.words[SPHAERA_VIDEO_V_ACTIVE / 4], 480 | 10 << 16);
        assert_int_equal(b.words[SPHAERA_VIDEO_V_SYNC / 4], 2 | 33 << 16);
    }
    sphaera_video(&s, NULL);
    assert_int_equal(b.words[SPHAERA_VIDEO / 4], 0);
}

/* Each result has words of its own. */
static void words(void **state) {
    (void)state;
    for (int i = SPHAERA_OK; i <= SPHAERA_OTHER_LEVELS; i++)
        for (int k = SPHAERA_OK; k <= SPHAERA_OTHER_LEVELS + 1; k++)
            if (i != k) assert_string_not_equal(sphaera_text(i), sphaera_text(k));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(versions), cmocka_unit_test(load),  cmocka_unit_test(load_end),
        cmocka_unit_test(files),    cmocka_unit_test(store), cmocka_unit_test(counters),
        cmocka_unit_test(words),    cmocka_unit_test(late),  cmocka_unit_test(ends),
        cmocka_unit_test(video),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
