/* script.h - inputs of the live view from a file, line by line
 * SPDX-License-Identifier: Apache-2.0
 *
 * docs/reference/tool.md has the language. Reading it knows nothing of time or windows.
 */
#ifndef SPH_VIEW_SCRIPT_H
#define SPH_VIEW_SCRIPT_H

#include "common/error.h"

enum {
    VIEW_SAY_KEY,
    VIEW_SAY_DOWN,
    VIEW_SAY_UP,
    VIEW_SAY_PRESS,
    VIEW_SAY_RELEASE,
    VIEW_SAY_MOVE,
    VIEW_SAY_CLICK,
    VIEW_SAY_WHEEL,
    VIEW_SAY_FINGER,
    VIEW_SAY_PINCH,
    VIEW_SAY_WAIT,
    VIEW_SAY_REFINED,
    VIEW_SAY_SCREENSHOT,
    VIEW_SAY_SCENE,
    VIEW_SAY_REPORT,
    VIEW_SAY_QUIT
};

struct view_say {
    int what, line;   /* VIEW_SAY_*; of the file */
    int button;       /* VIEW_BUTTON_*, of press and release */
    double number[3]; /* x, y, milliseconds; or what there is of them */
    char text[512];   /* key or file */
};

struct view_script {
    struct view_say *list;
    int n;
};

/* Reads a script. 0, or -1 with "file:line: ..." and nothing to free. */
int view_script_read(const char *path, struct view_script *script, struct sph_error *err);

void view_script_free(struct view_script *script);

#endif
