/* nff_surface.c - what surfaces look like: `f`, `fm`, `shading`, `shadows`, `texture`; see
 * nff_reader.h SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "scene/inside.h"
#include "scene/nff_reader.h"

int sph_nff_material(struct sph_reader *r, const char *record, const char *what, uint32_t *material,
                     struct sph_error *err) {
    if (r->scene->n_materials == 0)
        return sph_fail(err, "%s:%u: `%s`: no material (`f`) before this %s", r->lex.path,
                        r->lex.token_line, record, what);
    r->material_used = 1;
    *material = r->material;
    return 0;
}

/* Adds a material; it replaces the newest one if that is unused. */
static int add_material(struct sph_reader *r, struct sph_material *m, struct sph_error *err) {
    m->passes = r->clear && m->trans > 0;
    if (r->scene->n_materials > 0 && !r->material_used) {
        r->scene->materials[r->material] = *m;
        return 0;
    }
    r->material_used = 0;
    r->material = r->scene->n_materials;
    return sph_scene_add_material(r->scene, m, err);
}

/* Shine and what follows it, which both records end with: Shine T index. */
static int check_tail(struct sph_reader *r, const char *record, const double tail[3],
                      struct sph_error *err) {
    static const char *const names[] = {"T"};
    if (sph_nff_check_unit(r, record, names, 1, &tail[1], err)) return -1;
    if (tail[0] < 0) return sph_nff_fail(r, err, record, "Shine is negative");
    if (tail[2] < 0) return sph_nff_fail(r, err, record, "index of refraction is negative");
    return 0;
}

/* Limits a number of the material to low..high; notes it as `kind`. */
static int limit(struct sph_reader *r, double *value, double low, double high, enum sph_read kind,
                 uint32_t line, struct sph_error *err) {
    double limited = fmin(fmax(*value, low), high);
    if (limited == *value) return 0;
    *value = limited;
    return sph_nff_note(r, kind, line, err);
}

/* [Ka Kr] */
static int take_shading(struct sph_reader *r, const char *record, struct sph_material *m,
                        struct sph_error *err) {
    static const char *const names[] = {"Ka", "Kr"};
    double share[2] = {m->kd, m->ks};
    int got = sph_nff_more(r, record, names, 2, share, err);
    if (got < 0) return -1;
    if (got && r->shading != SPH_SHADING_SUM)
        return sph_nff_fail(r, err, record, "Ka and Kr need `shading sum`");
    return sph_nff_check_unit(r, record, names, 2, share, err) || sph_nff_shade(r, share, m, err)
               ? -1
               : 0;
}

int sph_nff_shade(struct sph_reader *r, const double share[2], struct sph_material *m,
                  struct sph_error *err) {
    const double one = SPH_INDEX_ONE;
    uint32_t line = (uint32_t)m->line;
    int shines = m->ks > 0 && m->shine > 0;
    if (r->shading == SPH_SHADING_BLEND)
        return shines || m->trans > 0 ? sph_nff_note(r, SPH_READ_BLEND, line, err) : 0;
    if (m->ks > 0 && !shines && sph_nff_note(r, SPH_READ_SHINE_NONE, line, err)) return -1;
    if (r->shading == SPH_SHADING_NFF && !shines && !(m->trans > 0) && m->kd + m->ks <= 1) return 0;
    m->sum = (struct sph_sum){.on = 1, .ka = share[0], .kr = share[1]};
    if (!shines) m->ks = 0;
    if (shines &&
        limit(r, &m->shine, SPH_SHINE_MIN, SPH_SHINE_MAX, SPH_READ_SHINE_LIMITED, line, err))
        return -1;
    if (!(m->trans > 0)) return 0;
    if (m->ior == 0) {
        m->ior = 1;
        return sph_nff_note(r, SPH_READ_INDEX_LIMITED, line, err);
    }
    return limit(r, &m->ior, SPH_INDEX_MIN / one, SPH_INDEX_MAX / one, SPH_READ_INDEX_LIMITED, line,
                 err);
}

/* f red green blue Kd Ks Shine T index [Ka Kr] */
int sph_nff_take_f(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"red", "green", "blue", "Kd",
                                        "Ks",  "Shine", "T",    "index of refraction"};
    enum { N = 8, N_UNIT = 5 };
    double f[N];
    int line = (int)r->lex.token_line;
    if (sph_nff_numbers(r, "f", names, N, f, err) ||
        sph_nff_check_unit(r, "f", names, N_UNIT, f, err) || check_tail(r, "f", f + N_UNIT, err))
        return -1;
    struct sph_material m = {{f[0], f[1], f[2]}, f[3], f[4], f[5], f[6], f[7], line, {0}, 0};
    return take_shading(r, "f", &m, err) ? -1 : add_material(r, &m, err);
}

/* Whether an `fm` says what an `f` cannot: an ambient colour of its own, coloured highlights. */
static int says_more(const double ambient[3], const double diffuse[3], const double specular[3]) {
    for (int i = 0; i < 3; i++)
        if (ambient[i] != diffuse[i] || specular[i] != specular[0]) return 1;
    return 0;
}

/* fm ambient(3) diffuse(3) specular(3) Shine T index [Ka Kr], of AFF. Ambient colours are not used:
 * there is one ambient light. The mirror weight is one number: the mean of the specular colour. */
int sph_nff_take_fm(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"ambient red",
                                        "ambient green",
                                        "ambient blue",
                                        "diffuse red",
                                        "diffuse green",
                                        "diffuse blue",
                                        "specular red",
                                        "specular green",
                                        "specular blue",
                                        "Shine",
                                        "T",
                                        "index of refraction"};
    enum { N = 12, N_UNIT = 9, DIFFUSE = 3, SPECULAR = 6 };
    double f[N];
    int line = (int)r->lex.token_line;
    if (sph_nff_numbers(r, "fm", names, N, f, err) ||
        sph_nff_check_unit(r, "fm", names, N_UNIT, f, err) || check_tail(r, "fm", f + N_UNIT, err))
        return -1;
    const double *d = f + DIFFUSE, *s = f + SPECULAR;
    if (says_more(f, d, s) && sph_nff_note(r, SPH_READ_FM_MEAN, (uint32_t)line, err)) return -1;
    double kd = fmax(d[0], fmax(d[1], d[2])), by = kd > 0 ? kd : 1;
    struct sph_material m = {{d[0] / by, d[1] / by, d[2] / by},
                             kd,
                             (s[0] + s[1] + s[2]) / 3,
                             f[9],
                             f[10],
                             f[11],
                             line,
                             {0},
                             0};
    return take_shading(r, "fm", &m, err) ? -1 : add_material(r, &m, err);
}

/* One of two words, which says what holds for the materials that follow: *on if it is `yes`. */
static int take_either(struct sph_reader *r, const char *record, const char *no, const char *yes,
                       int *on, struct sph_error *err) {
    int got = sph_lex_peek(&r->lex, err);
    if (got < 0) return -1;
    if (!got)
        return sph_fail(err, "%s:%u: `%s`: the file ends before %s or %s", r->lex.path,
                        r->lex.token_line, record, no, yes);
    sph_lex_take(&r->lex);
    *on = !strcmp(r->lex.token, yes);
    if (*on || !strcmp(r->lex.token, no)) return 0;
    return sph_fail(err, "%s:%u: `%s`: `%s` is neither %s nor %s", r->lex.path, r->lex.token_line,
                    record, sph_lex_printable(&r->lex), no, yes);
}

/* shading blend, or shading sum */
int sph_nff_take_shading(struct sph_reader *r, struct sph_error *err) {
    int sum;
    if (take_either(r, "shading", "blend", "sum", &sum, err)) return -1;
    r->shading = sum ? SPH_SHADING_SUM : SPH_SHADING_BLEND;
    return 0;
}

/* shadows full, or shadows clear */
int sph_nff_take_shadows(struct sph_reader *r, struct sph_error *err) {
    return take_either(r, "shadows", "full", "clear", &r->clear, err);
}

int sph_nff_image(struct sph_reader *r, const char *record, char path[512], struct sph_error *err) {
    enum { SIZE = 512 };
    char name[SIZE];
    int got = sph_lex_name(&r->lex, record, "image file", name, sizeof name, err);
    if (got < 0) return -1;
    if (got == SPH_NAME_BARE && !strcmp(name, "none")) return 0;
    if (!*name) return sph_nff_fail(r, err, record, "the name of the image file is empty");
    const char *scene = r->lex.aff ? r->lex.path : r->scene->path, *slash = strrchr(scene, '/');
    int folder = slash && name[0] != '/' ? (int)(slash - scene) + 1 : 0;
    int length = snprintf(path, SIZE, "%.*s%s", folder, scene, name);
    if (r->lex.aff && name[0] != '/' && length < SIZE && access(path, F_OK)) {
        char beside[SIZE];
        int n = snprintf(beside, SIZE, "%.*s../TextureFiles/%s", folder, scene, name);
        if (n < SIZE && !access(beside, F_OK)) memcpy(path, beside, SIZE), length = n;
    }
    if (length >= SIZE)
        return sph_nff_fail(r, err, record, "the path of the image file is too long");
    if (!sph_scene_may_read(r->scene, path))
        return sph_fail(err, "%s:%u: `%s`: image %s " SPH_OUTSIDE, r->lex.path, r->lex.token_line,
                        record, name);
    return 1;
}

int sph_nff_find_texture(struct sph_reader *r, const struct sph_texture *texture, uint32_t *index,
                         struct sph_error *err) {
    struct sph_scene *scene = r->scene;
    for (uint32_t i = 0; i < scene->n_textures; i++) {
        const struct sph_texture *t = &scene->textures[i];
        if (memcmp(t->wrap, texture->wrap, sizeof t->wrap) != 0 || t->colours != texture->colours ||
            strcmp(t->path, texture->path))
            continue;
        if (t->repeat[0] == texture->repeat[0] && t->repeat[1] == texture->repeat[1] &&
            t->offset[0] == texture->offset[0] && t->offset[1] == texture->offset[1]) {
            *index = i + 1;
            return 0;
        }
    }
    if (sph_scene_add_texture(scene, texture, err)) return -1;
    *index = scene->n_textures;
    return 0;
}

int sph_nff_colours(struct sph_reader *r, int *colours, struct sph_error *err) {
    int got = sph_lex_peek(&r->lex, err);
    if (got < 0) return -1;
    *colours = !got || !strcmp(r->lex.token, "srgb") ? SPH_COLOURS_SRGB : SPH_COLOURS_LINEAR;
    if (got && (*colours == SPH_COLOURS_SRGB || !strcmp(r->lex.token, "linear")))
        sph_lex_take(&r->lex);
    else
        *colours = SPH_COLOURS_OF_FILE;
    return 0;
}

/* texture FILE su sv [ou ov] [clamp] [srgb|linear], or texture none */
int sph_nff_take_texture(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"su", "sv", "ou", "ov"};
    struct sph_texture t = {.line = r->lex.token_line};
    int got = sph_nff_image(r, "texture", t.path, err);
    if (got <= 0) {
        r->texture = 0;
        return got;
    }
    if (sph_nff_numbers(r, "texture", names, 2, t.repeat, err)) return -1;
    for (int i = 0; i < 2; i++)
        if (!(t.repeat[i] > 0))
            return sph_fail(err, "%s:%u: `texture`: %s %g is not positive", r->lex.path,
                            r->lex.token_line, names[i], t.repeat[i]);
    if (sph_nff_more(r, "texture", names + 2, 2, t.offset, err) < 0) return -1;
    got = sph_lex_peek(&r->lex, err);
    if (got < 0) return -1;
    if (got && !strcmp(r->lex.token, "clamp")) {
        sph_lex_take(&r->lex);
        t.wrap[0] = t.wrap[1] = 1;
    }
    if (sph_nff_colours(r, &t.colours, err)) return -1;
    return sph_nff_find_texture(r, &t, &r->texture, err);
}
