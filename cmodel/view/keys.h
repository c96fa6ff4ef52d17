/* keys.h - what the keys and the mouse of the live view do: the one list of them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_KEYS_H
#define SPH_VIEW_KEYS_H

#include <stdio.h>

/* Layers: what the colours of the picture tell. In the order of their keys. */
enum {
    VIEW_RENDERING, /* SPH_FRAMES layers of light come first */
    VIEW_L1,
    VIEW_L2,
    VIEW_DEPTHS,
    VIEW_VISITS,
    VIEW_LEVELS,
    VIEW_NORMALS,
    VIEW_DISTANCE,
    VIEW_DIFFERENCE,
    VIEW_LAYERS
};

/* What a key asks for; VIEW_DO_LAYER + n is layer n. Those before VIEW_ONCE go on while the key is
 * down. */
enum {
    VIEW_DO_FORWARD,
    VIEW_DO_BACK,
    VIEW_DO_LEFT,
    VIEW_DO_RIGHT,
    VIEW_DO_UP,
    VIEW_DO_DOWN,
    VIEW_DO_LOOK_LEFT,
    VIEW_DO_LOOK_RIGHT,
    VIEW_DO_LOOK_UP,
    VIEW_DO_LOOK_DOWN,
    VIEW_DO_NARROWER,
    VIEW_DO_WIDER,
    VIEW_ONCE,
    VIEW_DO_TREE = VIEW_ONCE,
    VIEW_DO_BACKGROUND,
    VIEW_DO_DEPTH,
    VIEW_DO_PROFILE,
    VIEW_DO_HOME,
    VIEW_DO_HEAD,
    VIEW_DO_PRICE,
    VIEW_DO_CAMERA,
    VIEW_DO_CLEAR,
    VIEW_DO_HELP,
    VIEW_DO_QUIT,
    VIEW_DO_LAYER,
    VIEW_DO_NOTHING = VIEW_DO_LAYER + VIEW_LAYERS
};

struct view_key {
    const char *name; /* as SDL_GetKeyName() has it, in small letters; NULL: the mouse, fingers */
    int does;         /* VIEW_DO_* */
    const char *by, *text; /* by: what is done, of the mouse and fingers alone */
};

extern const struct view_key view_keys[]; /* ends with one that has no text */
extern const char *const view_layer_names[VIEW_LAYERS];

/* What a key asks for, by its name in letters of either size; VIEW_DO_NOTHING if it does nothing.
 */
int view_key_does(const char *name);

/* The list as a table of Markdown. */
void view_keys_print(FILE *to);

#endif
