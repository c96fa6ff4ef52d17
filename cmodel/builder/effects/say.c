/* say.c - where in the scene file something stands, and what was asked; see effects.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdio.h>

#include "builder/effects/effects.h"
#include "builder/emit.h"

struct sph_place sph_place_of(const struct sph_scene *scene, uint32_t line, const char *what,
                              uint32_t index) {
    struct sph_place place;
    if (line)
        snprintf(place.text, sizeof place.text, "%s:%u", scene->path, line);
    else
        snprintf(place.text, sizeof place.text, "%s %u", what, index + 1);
    return place;
}

struct sph_place sph_sphere_place(const struct sph_scene *scene, uint32_t index) {
    return sph_place_of(scene, scene->spheres[index].line, "number", index);
}

struct sph_place sph_light_place(const struct sph_scene *scene, int index) {
    return sph_place_of(scene, scene->lights[index].line, "light", (uint32_t)index);
}

void sph_settle(struct sph_effect_report *entry, int asked) {
    char found[sizeof entry->why] = "";
    entry->on = asked == SPH_AUTO ? entry->called : asked;
    entry->left_out = entry->left_out && !entry->on && asked == SPH_AUTO;
    if (asked == SPH_AUTO) return;
    sph_note(found, sizeof found, "%s", entry->why);
    entry->why[0] = 0;
    sph_note(entry->why, sizeof entry->why, "as asked; %scalled for: %s",
             entry->called ? "" : "not ", found);
}

void sph_drop(struct sph_effect_report *entry, const char *why) {
    entry->on = 0;
    snprintf(entry->why, sizeof entry->why, "though on was asked: %s", why);
}
