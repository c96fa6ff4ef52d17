/* pov_write.c - camera, lights and primitives of a scene for POV-Ray; see pov_write.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * POV-Ray passes over what is nearer than 1/1000 to where a ray starts, and farther than 10^7. So
 * all is scaled by a power of two, to 2^16 around the eye; planes, seen far beyond, to 2^12.
 */
#include "scene/pov_write.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <string.h>

#include "machine/records.h"
#include "scene/nesting.h"
#include "scene/pov_image.h"
#include "scene/pov_surface.h"
#include "scene/vector.h"
#include "scene/window.h"

enum { EXTENT_LOG2 = 16, EXTENT_LOG2_PLANE = 12 };

struct writer {
    const struct sph_scene *scene;
    FILE *file;
    double scale;
};

static double distance(struct sph_vec a, struct sph_vec b) {
    return sph_vec_length(sph_vec_sub(a, b));
}

/* A facet without bounds: a plane. */
static int unbounded(const struct sph_scene *s, uint32_t facet) {
    return sph_kind_unbounded((uint32_t)s->facets[facet].kind);
}

/* The power of two that brings spheres, triangles and points of planes so near to the eye. */
static double scale_of(const struct sph_scene *s) {
    double most = distance(s->camera.from, s->camera.at);
    int log2, extent = EXTENT_LOG2;
    for (uint32_t i = 0; i < s->n_spheres; i++)
        most = fmax(most, distance(s->spheres[i].ctr, s->camera.from) + s->spheres[i].rad);
    for (uint32_t i = 0; i < s->n_facets; i++) {
        int one = unbounded(s, i); /* point of it */
        if (one) extent = EXTENT_LOG2_PLANE;
        for (int k = 0; k < (one ? 1 : 3); k++)
            most = fmax(most, distance(s->facets[i].v[k], s->camera.from));
    }
    frexp(most, &log2);
    return ldexp(1, extent - log2);
}

static void put_point(const struct writer *w, struct sph_vec v) {
    sph_pov_vector(w->file, (double[]){v.x * w->scale, v.y * w->scale, v.z * w->scale});
}

/* A direction by its word, in pixels. */
static void put_direction(const struct writer *w, const char *word, struct sph_vec v,
                          double pixels) {
    fprintf(w->file, " %s ", word);
    sph_pov_vector(w->file, (double[]){v.x * pixels, v.y * pixels, v.z * pixels});
}

/* The screen is a window of width x height pixels, as far away as the field of view asks for; the
 * ray through its middle need not be square to it. */
static void put_camera(const struct writer *w, int width, int height) {
    const struct sph_camera *c = &w->scene->camera;
    struct sph_vec ahead = sph_vec_unit(sph_vec_sub(c->at, c->from));
    struct sph_vec right = sph_vec_unit(sph_vec_cross(ahead, c->up)),
                   up = sph_vec_cross(right, ahead);
    fputs("camera { location ", w->file);
    put_point(w, c->from);
    struct sph_window window = sph_window_of(c, width, height);
    double aside = window.left + (width - 1) / 2.0, above = window.top - (height - 1) / 2.0;
    struct sph_vec middle = {
        window.screen * ahead.x + aside * right.x + above * up.x,
        window.screen * ahead.y + aside * right.y + above * up.y,
        window.screen * ahead.z + aside * right.z + above * up.z,
    };
    put_direction(w, "direction", middle, 1);
    put_direction(w, "right", right, width);
    put_direction(w, "up", up, height);
    fputs(" }\n", w->file);
}

static void put_head(const struct writer *w, const struct sph_pov_options *o, int width,
                     int height) {
    FILE *f = w->file;
    fputs("// Scene ", f);
    for (const char *c = w->scene->name; *c; c++)
        putc((unsigned char)*c < 32 || *c == 127 ? '?' : *c, f);
    fprintf(f,
            " for POV-Ray 3.7, lengths times %.15g\n"
            "// povray FILE.pov +W%d +H%d -A -D +FE +OFILE.exr\n"
            "// Add Declare=Ids=1 for the numbers of primitives in flat colours; what else may\n"
            "// be declared, how surfaces at the last reflection come out: docs/reference/tool.md\n"
            "#version 3.7;\n"
            "#ifndef (Reflections) #declare Reflections = %d; #end\n"
            "#ifndef (Whole) #declare Whole = 0; #end\n"
            "#ifndef (Ids) #declare Ids = 0; #end\n"
            "global_settings { assumed_gamma 1 adc_bailout 0 max_trace_level Reflections + 1 }\n"
            "#default { finish { ambient 0 diffuse 0 } }\n",
            w->scale, width, height, o->max_depth);
    put_camera(w, width, height);
    fputs("background { rgb (Ids ? <1,1,1> : ", f);
    sph_pov_vector(f, w->scene->background);
    fputs(") }\n", f);
}

static void put_sphere(const struct writer *w, uint32_t i) {
    const struct sph_sphere *s = &w->scene->spheres[i];
    fputs("sphere { ", w->file);
    put_point(w, s->ctr);
    putc(',', w->file);
    sph_pov_number(w->file, s->rad * w->scale);
}

static void put_triangle(const struct writer *w, const struct sph_facet *f) {
    fputs(f->smooth ? "smooth_triangle { " : "triangle { ", w->file);
    for (int k = 0; k < 3; k++) {
        if (k) putc(',', w->file);
        put_point(w, f->v[k]);
        if (!f->smooth) continue;
        struct sph_vec n = sph_vec_unit(f->n[k]);
        putc(',', w->file);
        sph_pov_vector(w->file, (double[]){n.x, n.y, n.z});
    }
}

static void put_plane(const struct writer *w, const struct sph_facet *f) {
    struct sph_vec n = sph_vec_unit(f->v[1]), p = f->v[0];
    fputs("plane { ", w->file);
    sph_pov_vector(w->file, (double[]){n.x, n.y, n.z});
    putc(',', w->file);
    sph_pov_number(w->file, (n.x * p.x + n.y * p.y + n.z * p.z) * w->scale);
}

static void (*const put_facet[SPH_KINDS])(const struct writer *, const struct sph_facet *) = {
    [SPH_TRIANGLE] = put_triangle, [SPH_PLANE] = put_plane};

/* A primitive by its number, without the bracket that ends it; its material. */
static uint32_t put_shape(const struct writer *w, uint32_t id) {
    if (id < w->scene->n_spheres) {
        put_sphere(w, id);
        return w->scene->spheres[id].material;
    }
    const struct sph_facet *f = &w->scene->facets[id - w->scene->n_spheres];
    put_facet[f->kind](w, f);
    return f->material;
}

static int clear(const struct sph_scene *s, uint32_t material) {
    return sph_material_clear(&s->materials[material]);
}

/* The texture of a primitive: of its material, or its image in that. */
static void put_look(const struct writer *w, uint32_t id, uint32_t material) {
    const struct sph_scene *s = w->scene;
    int round = id < s->n_spheres;
    const struct sph_facet *f = round ? NULL : &s->facets[id - s->n_spheres];
    if (!(round ? s->spheres[id].texture : f->texture)) {
        fprintf(w->file, " Look(%u,%u)", material, id);
        return;
    }
    fprintf(w->file, "\n#if (Ids) Look(%u,%u) #else texture { Looks[%u] ", material, id, material);
    if (round)
        sph_pov_round(s, &s->spheres[id], w->scale, w->file);
    else
        sph_pov_flat(s, f, w->scale, w->file);
    fputs(" } #end", w->file);
}

/* Whether shadow rays pass a material. */
static int passes(const struct writer *w, uint32_t material) {
    return w->scene->materials[material].passes;
}

/* Whether the eye is inside of a sphere, or behind a plane. */
static int around_eye(const struct sph_scene *s, uint32_t id) {
    struct sph_vec eye = s->camera.from;
    if (id < s->n_spheres) return distance(s->spheres[id].ctr, eye) < s->spheres[id].rad;
    const struct sph_facet *f = &s->facets[id - s->n_spheres];
    return sph_vec_dot(sph_vec_sub(eye, f->v[0]), f->v[1]) < 0;
}

/* What is transparent hides a light whole: the surface itself throws no shadow, and an opaque one
 * that is nowhere seen does, unless shadow rays pass. POV-Ray takes the eye to be in all that it is
 * inside of, and bends no ray that leaves the glass while it is in the opaque one: that is turned
 * inside out there. */
static void put_primitive(const struct writer *w, uint32_t id) {
    uint32_t material = put_shape(w, id);
    put_look(w, id, material);
    if (clear(w->scene, material)) {
        fprintf(w->file, " Inside(%u) no_shadow", material);
        if (!passes(w, material)) {
            fputs(" }\n", w->file);
            put_shape(w, id);
            fputs(around_eye(w->scene, id) ? " Shade() inverse" : " Shade()", w->file);
        }
    } else if (passes(w, material)) {
        fputs(" no_shadow", w->file);
    }
    fputs(" }\n", w->file);
}

/* The facets of a transparent material bound what is inside of them together. */
static void put_solid(const struct writer *w, uint32_t material) {
    const struct sph_scene *s = w->scene;
    uint32_t n = 0;
    for (int shade = 0; shade < 2 - passes(w, material); shade++) {
        for (uint32_t i = 0; i < s->n_facets; i++) {
            if (unbounded(s, i) || s->facets[i].material != material) continue;
            if (!n++) fputs("union {\n", w->file);
            put_facet[s->facets[i].kind](w, &s->facets[i]);
            if (!shade) put_look(w, s->n_spheres + i, material);
            fputs(" }\n", w->file);
        }
        if (n && shade) fputs("Shade() }\n", w->file);
        if (n && !shade) fprintf(w->file, "Inside(%u) no_shadow }\n", material);
        n = 0;
    }
}

static void put_scene(const struct writer *w, const struct sph_pov_options *o) {
    const struct sph_scene *s = w->scene;
    put_head(w, o, o->width ? o->width : s->camera.width, o->height ? o->height : s->camera.height);
    for (int i = 0; i < s->n_lights; i++) {
        fputs("light_source { ", w->file);
        put_point(w, s->lights[i].pos);
        fputs(" rgb ", w->file);
        sph_pov_vector(w->file, s->lights[i].rgb);
        fputs(" }\n", w->file);
    }
    sph_pov_surfaces(s, w->file);
    sph_pov_images(s, w->file);
    for (uint32_t i = 0; i < s->n_spheres; i++)
        put_primitive(w, i);
    for (uint32_t i = 0; i < s->n_facets; i++)
        if (unbounded(s, i) || !clear(s, s->facets[i].material)) put_primitive(w, s->n_spheres + i);
    for (uint32_t i = 0; i < s->n_materials; i++)
        if (clear(s, i)) put_solid(w, i);
}

int sph_scene_write_pov(const struct sph_scene *scene, const struct sph_pov_options *options,
                        FILE *file, struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_facets; i++)
        if (!put_facet[scene->facets[i].kind])
            return sph_fail(err, "%s:%d: a %s cannot be written for POV-Ray", scene->path,
                            scene->facets[i].line, sph_kind_name((uint32_t)scene->facets[i].kind));
    locale_t c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c_locale) return sph_fail(err, "%s: no memory to write", scene->path);
    locale_t before = uselocale(c_locale);
    struct writer w = {scene, file, scale_of(scene)};
    put_scene(&w, options);
    uselocale(before);
    freelocale(c_locale);
    if (fflush(file) || ferror(file))
        return sph_fail(err, "%s: cannot write: %s", scene->path, strerror(errno));
    return 0;
}
