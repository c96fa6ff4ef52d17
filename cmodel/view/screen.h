/* screen.h - a window, and what happens in it: all that the live view asks of a library
 * SPDX-License-Identifier: Apache-2.0
 *
 * sdl/screen.c is the one file that knows SDL2. It becomes an object of its own, which the tool
 * loads, so that the tool does not hang on it.
 */
#ifndef SPH_VIEW_SCREEN_H
#define SPH_VIEW_SCREEN_H

#include <stdint.h>

#include "common/error.h"

enum {
    VIEW_NOTHING,
    VIEW_KEY_DOWN,
    VIEW_KEY_UP,
    VIEW_BUTTON_DOWN,
    VIEW_BUTTON_UP,
    VIEW_MOVE,
    VIEW_WHEEL,
    VIEW_FINGER,
    VIEW_PINCH,
    VIEW_EXPOSED,
    VIEW_CLOSED
};
enum { VIEW_BUTTON_LEFT = 1, VIEW_BUTTON_MIDDLE, VIEW_BUTTON_RIGHT, VIEW_BUTTONS };

struct view_event {
    int kind;
    char key[24]; /* its name, of VIEW_KEY_* */
    int button;   /* VIEW_BUTTON_*, of these */
    double x, y;  /* pixels of the picture; VIEW_WHEEL: y clicks away from the user; VIEW_FINGER:
                     parts of the window to the right and down; VIEW_PINCH: y parts of it apart */
};

struct view_screen;

struct view_screen_calls {
    /* A window of width x height pixels. NULL with a message. */
    struct view_screen *(*open)(int width, int height, struct sph_error *err);
    void (*close)(struct view_screen *screen);
    void (*title)(struct view_screen *screen, const char *text);
    /* Waits up to so many seconds for an event. 1 with the next one, which may be VIEW_NOTHING, or
     * 0. */
    int (*next)(struct view_screen *screen, double seconds, struct view_event *event);
    /* Puts an event where those of the user come from. */
    void (*push)(struct view_screen *screen, const struct view_event *event);
    /* Shows pixels of 0xBBGGRR, as large as the window was opened. */
    void (*show)(struct view_screen *screen, const uint32_t *pixels);
    /* Reads back what the window shows. -1 with a message if it cannot be, or has another size. */
    int (*read)(struct view_screen *screen, uint32_t *pixels, struct sph_error *err);
};

/* The calls of the object that knows SDL2; NULL with a message that says what to install. */
const struct view_screen_calls *view_screen_load(struct sph_error *err);

#endif
