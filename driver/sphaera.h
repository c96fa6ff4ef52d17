/* sphaera.h - driver of rt_top: freestanding C99, no memory of its own
 * SPDX-License-Identifier: Apache-2.0
 *
 *     struct sphaera s;
 *     sphaera_open(&s, &bus);                        identity, what the core was built with
 *     sphaera_load(&s, file, bytes, 0x10000000);     a machine file to memory, its registers
 *     sphaera_store(&s, frames, 2560, 0);            where frames go
 *     sphaera_start(&s, 0);
 *     sphaera_wait(&s, 100000000);                   or an interrupt and sphaera_handle()
 *
 * Every function that returns int gives SPHAERA_OK or one of the others, which sphaera_text() says
 * in words. The caller's bus reaches registers and memory; a processor that sees both in its own
 * address space needs four lines for it. Nothing here waits without an end: `polls` is how often
 * STATUS is read at most.
 */
#ifndef SPHAERA_H
#define SPHAERA_H

#include <stdint.h>

#include "sphaera_regs.h"

enum sphaera_result {
    SPHAERA_OK,
    SPHAERA_ABSENT,       /* the registers are not those of rt_top, or of another version */
    SPHAERA_BAD_FILE,     /* no machine file, or of another version, or cut off */
    SPHAERA_OTHER_WIDTHS, /* the machine was built for other widths */
    SPHAERA_TOO_MUCH,     /* the machine asks for an effect that the core has not */
    SPHAERA_MISPLACED,    /* an address or a stride is not a multiple of what it must be */
    SPHAERA_BUSY,         /* a frame is drawn, or the block is drained */
    SPHAERA_LATE,         /* the time is over */
    SPHAERA_FAILED,       /* the frame had errors: sphaera_errors() */
    SPHAERA_NO_LAYERS,    /* the block was built without layers */
    SPHAERA_BEYOND,   /* an address, or the end of what lies there, is not in its address space */
    SPHAERA_TOO_DEEP, /* the machine follows more reflections than the core */
    SPHAERA_TOO_MANY_LIGHTS,
    SPHAERA_OTHER_TREE,    /* it has nodes, a BIH or boxes, and the core walks another of them */
    SPHAERA_NO_BACKGROUND, /* the core lacks its rectangle, spans or cones of the background */
    SPHAERA_OTHER_LEVELS,  /* the core rounds away other bits of a texture's level */
    SPHAERA_NO_BUILDER,    /* the block was built without BUILD, or for fewer spheres */
    SPHAERA_NOT_BUILT      /* the tree had errors: sphaera_errors(); the last good one stays */
};

/* How the registers and the memory of the block are reached. Offsets are bytes, as in
 * sphaera_regs.h; addresses are those of the block's own bus.
 *
 * What the caller's functions owe each other, on a processor with caches or that reorders:
 *   put    ends when the block's masters would read what it wrote: written to memory that is not
 *          cached, or its cache lines cleaned, and a barrier of stores behind that
 *   write  is a store to a device, in the order of the calls, behind all that put() did before.
 *          What the caller itself changed in the memory of a machine has to be visible in the same
 *          way before sphaera_start(); with keep_cache nothing may have changed
 *   read   is a load from a device. Who looks at a frame behind sphaera_wait() or sphaera_take()
 *          puts a barrier of loads before that, and invalidates its cache lines of the frame:
 *          STATUS says that a frame ended only when its last write was answered by memory */
struct sphaera_bus {
    uint32_t (*read)(void *user, uint32_t offset);
    void (*write)(void *user, uint32_t offset, uint32_t value);
    void (*put)(void *user, uint64_t address, const uint8_t *bytes, uint32_t count);
    void *user;
};

struct sphaera {
    struct sphaera_bus bus;
    uint32_t profile, effects, parts, built; /* CORE_PROFILE, CORE_EFFECTS, CORE_PARTS, CORE_BUS */
};

/* Timing of a display, in pixels and rows; pol: 1 if the pulse is high. */
struct sphaera_mode {
    uint16_t h_active, h_front, h_sync, h_back, v_active, v_front, v_sync, v_back;
    uint8_t h_pol, v_pol, doubled;
};

/* Looks whether rt_top is there, and ends whatever it did before: SPHAERA_OK, SPHAERA_ABSENT or
 * SPHAERA_LATE, if its buses still owe answers. */
int sphaera_open(struct sphaera *s, const struct sphaera_bus *bus);

/* Puts the memory of a machine file at `base`, a multiple of 4096, and its registers into the
 * block. A frame that is drawn keeps its own registers; its memory must not be written over.
 * Nothing is put if the core would refuse the machine, or its memory does not lie below 2^32, or
 * 2^ADDR of a block with more address bits. */
int sphaera_load(struct sphaera *s, const uint8_t *file, uint32_t bytes, uint64_t base);

/* One register of the machine, SPHAERA_REG_*; counts from the next start on. */
void sphaera_set(struct sphaera *s, uint32_t number, uint32_t value);

/* Three frames at addresses that are multiples of 64, rows `stride` bytes apart, a multiple of 32;
 * rgb565: 16 bits a pixel in place of 32. Counts from the next start on. That their rows lie in the
 * address space is the caller's to see; of each the first is looked at. */
int sphaera_store(struct sphaera *s, const uint64_t frames[3], uint32_t stride, int rgb565);

/* Of a block that was built with layers: those of a frame, Rendering, L1 and L2, are `bytes` apart,
 * a multiple of 64. Counts from the next start on; a display follows at its next blanking. */
int sphaera_layers(struct sphaera *s, uint32_t bytes);

/* Which colours: 0 as register FRAME of the machine has it, 1 Rendering, 2 L1, 3 L2. They are
 * stored from the next start on; with layers they are shown from the next blanking or
 * sphaera_take() on. */
void sphaera_mux(struct sphaera *s, unsigned frame);

/* Where a block with BUILD finds the spheres, and where it puts trees: lines behind SCENE_BASE. The
 * two places have `lines` each, two for a sphere; machines that were built with tree `hw` have one
 * of them in front of their records, from line 0 on. */
struct sphaera_trees {
    uint32_t count;   /* spheres */
    uint32_t records; /* line of the primitive record of sphere 0 */
    uint32_t tree[2]; /* lines of the roots */
    uint32_t lines;
    unsigned order;  /* 0 along a curve, 1 the paper's, 2 that of the build before: a refit */
    unsigned rounds; /* of order 0: of joining that follow the first, 0 to 3 */
};

/* These count from the next BUILD on, and frames read the newest tree from the next START on;
 * NULL: they read that of register ROOT again. SPHAERA_NO_BUILDER if there is no builder, or none
 * for so many spheres. */
int sphaera_trees(struct sphaera *s, const struct sphaera_trees *trees);

/* Puts the lines of `after` that are not those of `before` to where both lie from `address` on, and
 * counts them in *put. Of primitive records these are the ones that moved. */
void sphaera_move(struct sphaera *s, const uint8_t *before, const uint8_t *after, uint32_t lines,
                  uint64_t address, uint32_t *put);

/* Builds a tree, also while a frame is drawn, whose own tree stays: one that lies where this would
 * go is waited for. draw: a frame is begun when it is built, and the frame before it is over. */
int sphaera_build(struct sphaera *s, int draw);

/* Waits for the end of the build: SPHAERA_OK, SPHAERA_NOT_BUILT, SPHAERA_LATE. */
int sphaera_build_wait(struct sphaera *s, uint32_t polls);

/* Begins a frame; keep_cache: memory did not change since the last one. */
int sphaera_start(struct sphaera *s, int keep_cache);

/* Ends the frame; it is not complete. */
void sphaera_stop(struct sphaera *s);

/* STOP, and errors, interrupts, counts of frames and the frame store start anew. If a bus never
 * answers this ends with SPHAERA_LATE; forget: that bus was reset, and owes nothing. */
int sphaera_reset(struct sphaera *s, int forget, uint32_t polls);

/* Waits for the end of the frame: SPHAERA_OK if it is complete, SPHAERA_FAILED, SPHAERA_LATE. */
int sphaera_wait(struct sphaera *s, uint32_t polls);

/* SPHAERA_INTERRUPTS_*: those that drive the interrupt line. */
void sphaera_interrupts(struct sphaera *s, uint32_t enabled);

/* Of an interrupt: what happened since the last call, SPHAERA_INTERRUPTS_*; cleared by it. */
uint32_t sphaera_handle(struct sphaera *s);

/* The frame that is shown changes to the newest one, where there is no video, and its layer to the
 * one that sphaera_mux() chose. In *frame the number of the frame, 0..2; SPHAERA_BUSY if none is
 * complete yet. */
int sphaera_take(struct sphaera *s, unsigned *frame);

/* Errors since the last call, SPHAERA_ERRORS_*; cleared by it. */
uint32_t sphaera_errors(struct sphaera *s);

/* The lowest of these errors in words; NULL if there is none. It is taken out of *errors. */
const char *sphaera_error_text(uint32_t *errors);

/* All counters as they are now: SPHAERA_COUNT_*. */
void sphaera_counters(struct sphaera *s, uint64_t counters[SPHAERA_COUNTS]);

/* Mode of the display, which is on from then on; NULL: it is off. */
void sphaera_video(struct sphaera *s, const struct sphaera_mode *mode);

/* A result in words. */
const char *sphaera_text(int result);

#endif
