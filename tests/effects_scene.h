/* effects_scene.h - for the tests of effects: what build leaves off changes no pixel
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TEST_EFFECTS_SCENE_H
#define SPH_TEST_EFFECTS_SCENE_H

#include "build_scene.h"

#include <math.h>
#include <string.h>

#include "builder/build.h"
#include "render/render.h"

/* The options of a machine with all that the scene may need, whatever build finds. */
static inline struct sph_build_options everything(const struct sph_scene *scene,
                                                  struct sph_build_options o) {
    o.shadow = o.inside = SPH_ON;
    o.lights = scene->n_lights;
    if (o.traverse == SPH_BUILD_FIRST) o.interpenetrate = SPH_ON;
    return o;
}

static inline struct sph_frame frame_of(const struct sph_machine *m) {
    struct sph_render_options o = {.threads = 1};
    struct sph_counters c = {{0}};
    struct sph_frame frame;
    struct sph_error err = {{0}};
    int errors = sph_render(m, &o, &frame, &c, &err);
    if (errors) fail_msg("%s: error bits %d %s", m->name, errors, err.text);
    return frame;
}

/* Pixels whose colours, id or key differ. */
static inline int frames_differ(const struct sph_frame *a, const struct sph_frame *b) {
    int count = 0;
    for (int i = 0; i < a->width * a->height; i++) {
        const struct sph_pixel *p = &a->pixels[i], *q = &b->pixels[i];
        count += p->id != q->id || p->key != q->key ||
                 memcmp(p->colour, q->colour, sizeof p->colour) != 0;
    }
    return count;
}

/* Prints how to see the scene of a frame that differs. */
static inline void print_scene(const struct sph_scene *s, const struct sph_build_options *o) {
    printf("# profile %s, tree %d, traverse %d, angle %.9g, %d spheres, %d lights\n",
           sph_profiles[o->profile].name, o->tree, o->traverse, s->camera.angle, (int)s->n_spheres,
           s->n_lights);
    for (int l = 0; l < s->n_lights; l++)
        printf("# l %.9g %.9g %.9g %g\n", s->lights[l].pos.x, s->lights[l].pos.y,
               s->lights[l].pos.z, s->lights[l].rgb[0]);
    for (uint32_t i = 0; i < s->n_spheres && i < 8; i++)
        printf("# s %.9g %.9g %.9g %.9g  ks %g\n", s->spheres[i].ctr.x, s->spheres[i].ctr.y,
               s->spheres[i].ctr.z, s->spheres[i].rad, s->materials[s->spheres[i].material].ks);
}

/* What the comparisons came to. */
struct tally {
    int frames, refused, wrong, seen; /* seen: pixels that show a sphere */
    int off[SPH_REPORTS];             /* frames without an effect that would have work */
};

/* Builds the scene as found and with everything, and compares the frames. */
static inline void compare(const struct sph_scene *scene, struct sph_build_options o,
                           struct tally *t) {
    static struct sph_build_report report, full;
    struct sph_build_options all = everything(scene, o);
    struct sph_machine some, every;
    struct sph_error err;
    if (sph_build(scene, &o, &some, &report, &err)) {
        t->refused++;
        return;
    }
    if (sph_build(scene, &all, &every, &full, &err)) fail_msg("%s", err.text);
    struct sph_frame a = frame_of(&some), b = frame_of(&every);
    int differ = frames_differ(&a, &b);
    if (differ && !t->wrong++) {
        printf("# %s: %d pixels differ\n", scene->name, differ);
        print_scene(scene, &o);
        for (int i = 0; i < SPH_REPORTS; i++)
            printf("# %s %d: %s\n", report.effects[i].name, report.effects[i].on,
                   report.effects[i].why);
    }
    t->frames++;
    for (int i = 0; i < a.width * a.height; i++)
        t->seen += a.pixels[i].id != SPH_ID_NONE;
    const struct sph_effect_report *e = report.effects;
    int lights = e[SPH_REPORT_LIGHTS].on, several = scene->n_spheres > 1;
    t->off[SPH_REPORT_SHADOW] += lights && several && !e[SPH_REPORT_SHADOW].on;
    t->off[SPH_REPORT_LIGHTS] += strstr(e[SPH_REPORT_LIGHTS].why, "shut in") != NULL;
    t->off[SPH_REPORT_INSIDE] += several && !e[SPH_REPORT_INSIDE].on;
    t->off[SPH_REPORT_INTERPENETRATE] +=
        several && e[SPH_REPORT_FIRST].on && !e[SPH_REPORT_INTERPENETRATE].on;
    sph_frame_free(&a);
    sph_frame_free(&b);
    sph_machine_free(&some);
    sph_machine_free(&every);
}

static inline void print_tally(const struct tally *t) {
    printf("# %d frames, %d refused, %d pixels show a sphere; off: shadow %d, a light shut in %d, "
           "inside %d, interpenetrate %d\n",
           t->frames, t->refused, t->seen, t->off[SPH_REPORT_SHADOW], t->off[SPH_REPORT_LIGHTS],
           t->off[SPH_REPORT_INSIDE], t->off[SPH_REPORT_INTERPENETRATE]);
    assert_int_equal(t->wrong, 0);
}

enum { SLOW = SANITIZED ? 10 : 1 };

#endif
