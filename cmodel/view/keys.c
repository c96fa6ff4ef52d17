/* keys.c - see keys.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/keys.h"

#include <string.h>
#include <strings.h>

const struct view_key view_keys[] = {
    {NULL, 0, "left button, drag", "orbits around what the camera looks at"},
    {NULL, 0, "right or middle button, drag", "pans: the camera moves in the plane of the picture"},
    {NULL, 0, "wheel", "zooms: nearer to what the camera looks at, or away from it"},
    {NULL, 0, "left button, click", "prints the rays of the pixel as a tree, and draws them"},
    {NULL, 0, "one finger", "pans"},
    {NULL, 0, "two fingers", "spread: walks forward; pinch: walks back"},
    {"w", VIEW_DO_FORWARD, NULL, "walks forward"},
    {"s", VIEW_DO_BACK, NULL, "walks back"},
    {"a", VIEW_DO_LEFT, NULL, "walks left"},
    {"d", VIEW_DO_RIGHT, NULL, "walks right"},
    {"e", VIEW_DO_UP, NULL, "walks up"},
    {"q", VIEW_DO_DOWN, NULL, "walks down"},
    {"left", VIEW_DO_LOOK_LEFT, NULL, "turns left"},
    {"right", VIEW_DO_LOOK_RIGHT, NULL, "turns right"},
    {"up", VIEW_DO_LOOK_UP, NULL, "turns up"},
    {"down", VIEW_DO_LOOK_DOWN, NULL, "turns down"},
    {"=", VIEW_DO_NARROWER, NULL, "narrows the angle of the view"},
    {"-", VIEW_DO_WIDER, NULL, "widens it"},
    {"1", VIEW_DO_LAYER + VIEW_RENDERING, NULL, "Rendering: without reflections"},
    {"2", VIEW_DO_LAYER + VIEW_L1, NULL, "L1: one reflection"},
    {"3", VIEW_DO_LAYER + VIEW_L2, NULL, "L2: all reflections and refractions"},
    {"4", VIEW_DO_LAYER + VIEW_DEPTHS, NULL, "surfaces one after another, as `render --depths`"},
    {"5", VIEW_DO_LAYER + VIEW_VISITS, NULL,
     "node visits of the pixel's rays: black 0, then blue, cyan, green, yellow, red, white from "
     "1024 on, logarithmic"},
    {"6", VIEW_DO_LAYER + VIEW_LEVELS, NULL,
     "level of the image seen first: the same colours from 0 to 8; grey: none"},
    {"7", VIEW_DO_LAYER + VIEW_NORMALS, NULL, "normals: x, y, z of -1 to 1 as red, green, blue"},
    {"8", VIEW_DO_LAYER + VIEW_DISTANCE, NULL,
     "distance: white at the eye, half as bright at what the camera looks at"},
    {"9", VIEW_DO_LAYER + VIEW_DIFFERENCE, NULL,
     "difference to the double reference, 16 times; blue: another primitive; once it is drawn"},
    {"t", VIEW_DO_TREE, NULL, "next tree: paper, balanced, bih, brute, reinserted, box4"},
    {"b", VIEW_DO_BACKGROUND, NULL, "next way of background separation: none, rect, spans, exact"},
    {"n", VIEW_DO_DEPTH, NULL, "next depth, 0 to 10"},
    {"p", VIEW_DO_PROFILE, NULL, "next profile: draft, standard, fine, reference"},
    {"0", VIEW_DO_HOME, NULL, "back to the camera of the scene"},
    {"f", VIEW_DO_HEAD, NULL,
     "the pointer is the head: the eye is in front of it, and the screen through what the camera "
     "looks at stays; again: the eye goes back"},
    {"m", VIEW_DO_PRICE, NULL,
     "measures this frame when the camera rests: dB, cycles a pixel; again: no longer"},
    {"v", VIEW_DO_CAMERA, NULL, "prints the camera as lines of NFF"},
    {"c", VIEW_DO_CLEAR, NULL, "clears the rays that are drawn"},
    {"h", VIEW_DO_HELP, NULL, "prints this list"},
    {"escape", VIEW_DO_QUIT, NULL, "ends"},
    {NULL, 0, NULL, NULL},
};

const char *const view_layer_names[VIEW_LAYERS] = {
    "Rendering", "L1", "L2", "depths", "visits", "levels", "normals", "distance", "difference"};

int view_key_does(const char *name) {
    for (const struct view_key *k = view_keys; k->text; k++)
        if (k->name && !strcasecmp(k->name, name)) return k->does;
    return VIEW_DO_NOTHING;
}

void view_keys_print(FILE *to) {
    fprintf(to, "| key | does |\n|---|---|\n");
    for (const struct view_key *k = view_keys; k->text; k++)
        fprintf(to, k->name ? "| `%s` | %s |\n" : "| %s | %s |\n", k->name ? k->name : k->by,
                k->text);
}
