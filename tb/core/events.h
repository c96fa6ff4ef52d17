/* events.h - what trials may meet, counted
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_EVENTS_H
#define TB_EVENTS_H

#define EVENTS(E)                                                                                  \
    E(RESET_1, "reset of 1 clock")                                                                 \
    E(RESET_2, "reset of 2 clocks")                                                                \
    E(RESET_3, "reset of 3 clocks")                                                                \
    E(RESET_4, "reset of 4 clocks")                                                                \
    E(RESET_5, "reset of 5 clocks")                                                                \
    E(RESET_IDLE, "reset of an idle core")                                                         \
    E(RESET_END, "reset around the end of a frame")                                                \
    E(RESET_AGAIN, "reset again within 3 clocks")                                                  \
    E(RESET_DRAIN, "reset until memory had answered")                                              \
    E(RESET_LATE, "... which owed a line")                                                         \
    E(RESET_PINS, "start and writes during a reset")                                               \
    E(RESET_START, "start in the clock behind a reset")                                            \
    E(RESET_KEEP, "caches kept behind a reset")                                                    \
    E(MACHINE, "another machine, no reset")                                                        \
    E(KEEP_SAME, "caches kept, memory the same")                                                   \
    E(KEEP_SAVED, "... and no node was asked for")                                                 \
    E(KEEP_CHANGED, "caches kept, memory changed")                                                 \
    E(BUSY_START, "start while busy")                                                              \
    E(BUSY_WRITE, "register written while busy")                                                   \
    E(LATE_WRITE, "register written in the clock of the start")                                    \
    E(AT_ONCE, "start in the clock behind the end")                                                \
    E(BEAT_0, "bus error in the first beat alone")                                                 \
    E(BEAT_1, "bus error in the second")                                                           \
    E(BEAT_2, "bus error in the third")                                                            \
    E(BEAT_3, "bus error in the fourth")                                                           \
    E(BEATS_MORE, "bus error in some or all beats")                                                \
    E(BUS_KEEP, "caches kept behind a bus error")                                                  \
    E(SILENT, "memory silent for long")                                                            \
    E(DEAD, "memory silent until a reset")                                                         \
    E(BLOCKED, "no pixel taken for long")                                                          \
    E(REFUSED_EFFECT, "refused: a missing effect")                                                 \
    E(REFUSED_PROFILE, "refused: another profile")                                                 \
    E(REFUSED_CAMERA, "refused: another camera")                                                   \
    E(REFUSED_ERROR, "refused: behind a frame with an error")                                      \
    E(EMPTY, "a window without a pixel")                                                           \
    E(ONE_PIXEL, "a window of one pixel")                                                          \
    E(TREE_WORDS, "random words in nodes and leaves")                                              \
    E(RECORD_WORDS, "... in records")                                                              \
    E(OTHER_WORDS, "... in facets, mappings, images, texels, tables")                              \
    E(REGISTERS, "registers with random legal values")                                             \
    E(REGISTER_WORDS, "registers with random words")                                               \
    E(MOVED, "a machine far behind in a large memory")                                             \
    E(MEMORY_FULL, "MEM_LINES at the last line used")                                              \
    E(MEMORY_SHORT, "MEM_LINES one less")                                                          \
    E(VISITS_FULL, "VISIT_LIMIT just enough")                                                      \
    E(VISITS_SHORT, "VISIT_LIMIT one less")                                                        \
    E(VISITS_MANY, "VISIT_LIMIT of 2^23 and more")                                                 \
    E(STACK_FULL, "a stack just full")                                                             \
    E(STACK_SHORT, "a stack one too small")                                                        \
    E(BAD_NODE, "clean frame behind BAD_NODE")                                                     \
    E(STACK_OVERFLOW, "clean frame behind STACK_OVERFLOW")                                         \
    E(VISIT_LIMIT, "clean frame behind VISIT_LIMIT")                                               \
    E(BUS_ERROR, "clean frame behind BUS_ERROR")

#define EVENT_ID(id, text) id,
#define EVENT_TEXT(id, text) text,
enum Event { EVENTS(EVENT_ID) EVENT_COUNT };

#endif
