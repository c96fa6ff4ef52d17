/* sphaera.c - driver of rt_top; see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "sphaera.h"

#include <stddef.h>

#include "sphaera_file.h"

static uint32_t get(const struct sphaera *s, uint32_t offset) {
    return s->bus.read(s->bus.user, offset);
}

static void put(const struct sphaera *s, uint32_t offset, uint32_t value) {
    s->bus.write(s->bus.user, offset, value);
}

/* Until none of the bits of STATUS is set. */
static int until_clear(const struct sphaera *s, uint32_t bits, uint32_t polls) {
    while (get(s, SPHAERA_STATUS) & bits)
        if (polls-- == 0) return SPHAERA_LATE;
    return SPHAERA_OK;
}

int sphaera_open(struct sphaera *s, const struct sphaera_bus *bus) {
    s->bus = *bus;
    uint32_t version = get(s, SPHAERA_VERSION) ^ SPHAERA_VERSION_RESET;
    if (get(s, SPHAERA_ID) != SPHAERA_ID_RESET || (version & SPHAERA_VERSION_MAJOR))
        return SPHAERA_ABSENT;
    s->profile = get(s, SPHAERA_CORE_PROFILE);
    s->effects = get(s, SPHAERA_CORE_EFFECTS);
    s->parts = get(s, SPHAERA_CORE_PARTS);
    s->built = get(s, SPHAERA_CORE_BUS);
    put(s, SPHAERA_INTERRUPT_ENABLE, 0);
    return sphaera_reset(s, 0, SPHAERA_WATCHDOG_RESET);
}

void sphaera_set(struct sphaera *s, uint32_t number, uint32_t value) {
    put(s, SPHAERA_MACHINE + 4 * number, value);
}

/* Address bits of the masters. */
static unsigned address_bits(const struct sphaera *s) {
    return (s->built & SPHAERA_CORE_BUS_ADDR) >> SPHAERA_CORE_BUS_ADDR_LSB;
}

/* Whether so many bytes at an address are in its address space. */
static int beyond(const struct sphaera *s, uint64_t address, uint32_t bytes) {
    const uint64_t end = (uint64_t)1 << address_bits(s);
    return address > end || bytes > end - address;
}

/* The high bits of an address, field `lsb` of their register. */
static void put_high(const struct sphaera *s, uint64_t address, unsigned lsb) {
    if (address_bits(s) <= 32) return;
    const uint32_t others = get(s, SPHAERA_ADDRESS_HIGH) & ~((uint32_t)255 << lsb);
    put(s, SPHAERA_ADDRESS_HIGH, others | (uint32_t)(address >> 32) << lsb);
}

/* What the core lacks of that which the machine asks for beside its effects. */
static int lacks(const struct sphaera *s, const struct sphaera_file *f) {
    const uint32_t asks = sphaera_file_asks(f), has = s->parts;
#define MORE(part) ((asks & SPHAERA_CORE_PARTS_##part) > (has & SPHAERA_CORE_PARTS_##part))
    if (MORE(DEPTH)) return SPHAERA_TOO_DEEP;
    if (MORE(LIGHTS)) return SPHAERA_TOO_MANY_LIGHTS;
    if (MORE(RECT) || MORE(SPANS) || MORE(CONES)) return SPHAERA_NO_BACKGROUND;
#undef MORE
    if ((asks ^ has) & (SPHAERA_CORE_PARTS_ACCEL | SPHAERA_CORE_PARTS_BOXES))
        return SPHAERA_OTHER_TREE;
    return (asks ^ has) & SPHAERA_CORE_PARTS_COARSE ? SPHAERA_OTHER_LEVELS : SPHAERA_OK;
}

int sphaera_load(struct sphaera *s, const uint8_t *file, uint32_t bytes, uint64_t base) {
    struct sphaera_file f;
    if (!sphaera_file_read(&f, file, bytes)) return SPHAERA_BAD_FILE;
    if ((uint32_t)base & ~SPHAERA_SCENE_BASE_PAGE) return SPHAERA_MISPLACED;
    if (beyond(s, base, f.memory_bytes)) return SPHAERA_BEYOND;
    if (sphaera_file_register(&f, SPHAERA_REG_PROFILE) != s->profile) return SPHAERA_OTHER_WIDTHS;
    if (sphaera_file_register(&f, SPHAERA_REG_EFFECTS) & ~s->effects) return SPHAERA_TOO_MUCH;
    const int lack = lacks(s, &f);
    if (lack) return lack;
    s->bus.put(s->bus.user, base, f.memory, f.memory_bytes);
    put(s, SPHAERA_SCENE_BASE, (uint32_t)base);
    put_high(s, base, SPHAERA_ADDRESS_HIGH_SCENE_LSB);
    for (uint32_t i = 0; i < SPHAERA_MACHINE_REGISTERS; i++)
        sphaera_set(s, i, sphaera_file_register(&f, i));
    return SPHAERA_OK;
}

int sphaera_store(struct sphaera *s, const uint64_t frames[3], uint32_t stride, int rgb565) {
    static const uint32_t at[3] = {SPHAERA_FRAME0, SPHAERA_FRAME1, SPHAERA_FRAME2};
    static const unsigned high[3] = {SPHAERA_ADDRESS_HIGH_FRAME0_LSB,
                                     SPHAERA_ADDRESS_HIGH_FRAME1_LSB,
                                     SPHAERA_ADDRESS_HIGH_FRAME2_LSB};
    if (stride & ~SPHAERA_STRIDE_UNITS) return SPHAERA_MISPLACED;
    for (int i = 0; i < 3; i++) {
        if ((uint32_t)frames[i] & ~SPHAERA_FRAME0_PLACE) return SPHAERA_MISPLACED;
        if (beyond(s, frames[i], stride)) return SPHAERA_BEYOND;
    }
    for (int i = 0; i < 3; i++) {
        put(s, at[i], (uint32_t)frames[i]);
        put_high(s, frames[i], high[i]);
    }
    put(s, SPHAERA_STRIDE, stride);
    put(s, SPHAERA_FORMAT, rgb565 ? SPHAERA_FORMAT_RGB565 : 0);
    return SPHAERA_OK;
}

int sphaera_layers(struct sphaera *s, uint32_t bytes) {
    if (!(s->built & SPHAERA_CORE_BUS_LAYERS)) return SPHAERA_NO_LAYERS;
    if (bytes & ~SPHAERA_LAYER_BYTES_UNITS) return SPHAERA_MISPLACED;
    put(s, SPHAERA_LAYER_BYTES, bytes);
    return SPHAERA_OK;
}

void sphaera_mux(struct sphaera *s, unsigned frame) {
    put(s, SPHAERA_MUX, frame & SPHAERA_MUX_FRAME);
}

/* Errors of a build, which says nothing of a frame. */
#define BUILD_ERRORS                                                                               \
    (SPHAERA_ERRORS_BUILD_MANY | SPHAERA_ERRORS_BUILD_ROOM | SPHAERA_ERRORS_BUILD_RECORD |         \
     SPHAERA_ERRORS_BUILD_BUS | SPHAERA_ERRORS_BUILD_ORDER | SPHAERA_ERRORS_BUILD_REFUSED)

int sphaera_trees(struct sphaera *s, const struct sphaera_trees *trees) {
    const uint32_t most = (s->built & SPHAERA_CORE_BUS_BUILD) >> SPHAERA_CORE_BUS_BUILD_LSB;
    if (!most || (trees && trees->count > (uint32_t)1 << most)) return SPHAERA_NO_BUILDER;
    put(s, SPHAERA_BUILD_MODE,
        trees ? SPHAERA_BUILD_MODE_ROOT | (trees->order & SPHAERA_BUILD_MODE_ORDER) |
                    (trees->rounds << SPHAERA_BUILD_MODE_ROUNDS_LSB & SPHAERA_BUILD_MODE_ROUNDS)
              : 0);
    if (!trees) return SPHAERA_OK;
    put(s, SPHAERA_BUILD_COUNT, trees->count);
    put(s, SPHAERA_BUILD_RECORDS, trees->records);
    put(s, SPHAERA_BUILD_TREE0, trees->tree[0]);
    put(s, SPHAERA_BUILD_TREE1, trees->tree[1]);
    put(s, SPHAERA_BUILD_LINES, trees->lines);
    return SPHAERA_OK;
}

void sphaera_move(struct sphaera *s, const uint8_t *before, const uint8_t *after, uint32_t lines,
                  uint64_t address, uint32_t *put_lines) {
    for (uint32_t at = 0; lines--; at += SPHAERA_LINE_BYTES) {
        uint32_t i = 0;
        while (i < SPHAERA_LINE_BYTES && before[at + i] == after[at + i])
            i++;
        if (i == SPHAERA_LINE_BYTES) continue;
        s->bus.put(s->bus.user, address + at, after + at, SPHAERA_LINE_BYTES);
        ++*put_lines;
    }
}

int sphaera_build(struct sphaera *s, int draw) {
    if (!(s->built & SPHAERA_CORE_BUS_BUILD)) return SPHAERA_NO_BUILDER;
    if (get(s, SPHAERA_STATUS) & (SPHAERA_STATUS_BUILDING | SPHAERA_STATUS_DRAINING))
        return SPHAERA_BUSY;
    put(s, SPHAERA_ERRORS, BUILD_ERRORS);
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_BUILD | (draw ? SPHAERA_CONTROL_START : 0));
    return SPHAERA_OK;
}

int sphaera_build_wait(struct sphaera *s, uint32_t polls) {
    if (until_clear(s, SPHAERA_STATUS_BUILDING, polls)) return SPHAERA_LATE;
    return get(s, SPHAERA_ERRORS) & BUILD_ERRORS ? SPHAERA_NOT_BUILT : SPHAERA_OK;
}

int sphaera_start(struct sphaera *s, int keep_cache) {
    if (get(s, SPHAERA_STATUS) & (SPHAERA_STATUS_BUSY | SPHAERA_STATUS_DRAINING))
        return SPHAERA_BUSY;
    put(s, SPHAERA_ERRORS, ~BUILD_ERRORS);
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_START | (keep_cache ? SPHAERA_CONTROL_KEEP_CACHE : 0));
    return SPHAERA_OK;
}

void sphaera_stop(struct sphaera *s) {
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_STOP);
}

int sphaera_reset(struct sphaera *s, int forget, uint32_t polls) {
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_SOFT_RESET | (forget ? SPHAERA_CONTROL_FORGET : 0));
    return until_clear(s, SPHAERA_STATUS_DRAINING, polls);
}

int sphaera_wait(struct sphaera *s, uint32_t polls) {
    if (until_clear(s, SPHAERA_STATUS_BUSY, polls)) return SPHAERA_LATE;
    return get(s, SPHAERA_ERRORS) & ~BUILD_ERRORS ? SPHAERA_FAILED : SPHAERA_OK;
}

void sphaera_interrupts(struct sphaera *s, uint32_t enabled) {
    put(s, SPHAERA_INTERRUPT_ENABLE, enabled);
}

uint32_t sphaera_handle(struct sphaera *s) {
    uint32_t happened = get(s, SPHAERA_INTERRUPTS);
    put(s, SPHAERA_INTERRUPTS, happened);
    return happened;
}

int sphaera_take(struct sphaera *s, unsigned *frame) {
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_TAKE);
    uint32_t status = get(s, SPHAERA_STATUS);
    *frame = (status & SPHAERA_STATUS_SHOWN) >> SPHAERA_STATUS_SHOWN_LSB;
    return status & SPHAERA_STATUS_VALID ? SPHAERA_OK : SPHAERA_BUSY;
}

uint32_t sphaera_errors(struct sphaera *s) {
    uint32_t errors = get(s, SPHAERA_ERRORS);
    put(s, SPHAERA_ERRORS, errors);
    return errors;
}

const char *sphaera_error_text(uint32_t *errors) {
    static const struct {
        uint32_t bit;
        const char *text;
    } words[] = {
#define ENTRY(bit, text) {bit, text},
        SPHAERA_EACH_ERROR(ENTRY)
#undef ENTRY
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (*errors & words[i].bit) {
            *errors &= ~words[i].bit;
            return words[i].text;
        }
    return NULL;
}

void sphaera_counters(struct sphaera *s, uint64_t counters[SPHAERA_COUNTS]) {
    put(s, SPHAERA_CONTROL, SPHAERA_CONTROL_SNAPSHOT);
    for (uint32_t i = 0; i < SPHAERA_COUNTS; i++) {
        uint64_t low = get(s, SPHAERA_COUNTERS + 8 * i);
        counters[i] = low | (uint64_t)get(s, SPHAERA_COUNTERS + 8 * i + 4) << 32;
    }
}

void sphaera_video(struct sphaera *s, const struct sphaera_mode *mode) {
    put(s, SPHAERA_VIDEO, 0);
    if (!mode) return;
    put(s, SPHAERA_VIDEO_H_ACTIVE,
        mode->h_active | (uint32_t)mode->h_front << SPHAERA_VIDEO_H_ACTIVE_FRONT_LSB);
    put(s, SPHAERA_VIDEO_H_SYNC,
        mode->h_sync | (uint32_t)mode->h_back << SPHAERA_VIDEO_H_SYNC_BACK_LSB);
    put(s, SPHAERA_VIDEO_V_ACTIVE,
        mode->v_active | (uint32_t)mode->v_front << SPHAERA_VIDEO_V_ACTIVE_FRONT_LSB);
    put(s, SPHAERA_VIDEO_V_SYNC,
        mode->v_sync | (uint32_t)mode->v_back << SPHAERA_VIDEO_V_SYNC_BACK_LSB);
    put(s, SPHAERA_VIDEO,
        SPHAERA_VIDEO_ENABLE | (mode->doubled ? SPHAERA_VIDEO_DOUBLE : 0) |
            (mode->h_pol ? SPHAERA_VIDEO_H_POL : 0) | (mode->v_pol ? SPHAERA_VIDEO_V_POL : 0));
}

const char *sphaera_text(int result) {
    static const char *const words[] = {
        "done",
        "no rt_top answers here, or one of another version",
        "this is no machine file of this version, or it is cut off",
        "the machine was built for other widths than the core has",
        "the machine asks for an effect that the core has not",
        "an address or a stride is not a multiple of what it must be",
        "a frame is drawn, or the block is drained",
        "the time is over",
        "the frame had errors",
        "the block was built without layers",
        "an address, or the end of what lies there, is beyond those that the block has",
        "the machine follows more reflections or refractions than the core",
        "the machine has more lights than the core",
        "the machine has another kind of tree than the core walks",
        "the core lacks the machine's rectangle, spans or cones of the background",
        "the core rounds away other bits of a texture's level than the machine asks for",
        "the block builds no trees, or none of so many spheres",
        "the tree had errors; the last good one stays",
    };
    size_t n = sizeof words / sizeof *words;
    return result >= 0 && (size_t)result < n ? words[result] : "no such result";
}
