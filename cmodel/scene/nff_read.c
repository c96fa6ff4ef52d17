/* nff_read.c - reads the Neutral File Format; see nff_reader.h and docs/reference/scene_format.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * NFF is Eric Haines' format of the Standard Procedural Databases (SPD). Their conventions hold:
 * vertical field of view, light 1/sqrt(number of lights) where no colour is given, Ks both
 * highlight and mirror weight.
 */
#include "scene/nff_reader.h"

#include <math.h>
#include <string.h>

#include "scene/prim.h"
#include "scene/frustum.h"
#include "scene/motion.h"
#include "scene/nesting.h"
#include "scene/nff_skip.h"

/* A colour that may be given once a file. */
static int take_colour_once(struct sph_reader *r, const char *record, uint32_t *line, double *rgb,
                            struct sph_error *err) {
    if (*line)
        return sph_fail(err, "%s:%u: second `%s`; the first is in line %u", r->lex.path,
                        r->lex.token_line, record, *line);
    *line = r->lex.token_line;
    if (sph_nff_numbers(r, record, sph_nff_colour, 3, rgb, err)) return -1;
    return sph_nff_check_unit(r, record, sph_nff_colour, 3, rgb, err);
}

static int take_size(struct sph_reader *r, const char *name, int *size, struct sph_error *err) {
    double value;
    if (sph_lex_number(&r->lex, "resolution", name, &value, err)) return -1;
    if (!(value >= 1 && value <= SPH_MAX_RESOLUTION && value == floor(value)))
        return sph_fail(err, "%s:%u: `resolution`: %s %g is not a whole number of 1 to %d",
                        r->lex.path, r->lex.token_line, name, value, SPH_MAX_RESOLUTION);
    *size = (int)value;
    return 0;
}

static int take_view_field(struct sph_reader *r, int field, struct sph_error *err) {
    struct sph_camera *camera = &r->scene->camera;
    switch (field) {
    case 0:
        return sph_nff_vec(r, "from", &camera->from, err);
    case 1:
        return sph_nff_vec(r, "at", &camera->at, err);
    case 2:
        return sph_nff_vec(r, "up", &camera->up, err);
    case 3:
        return sph_lex_number(&r->lex, "angle", "degrees", &camera->angle, err);
    case 4:
        return sph_lex_number(&r->lex, "hither", "distance", &camera->hither, err);
    case 5:
        return sph_lex_number(&r->lex, "shift", "X", &camera->shift[0], err) ||
                       sph_lex_number(&r->lex, "shift", "Y", &camera->shift[1], err)
                   ? -1
                   : 0;
    default:
        return take_size(r, "width", &camera->width, err) ||
                       take_size(r, "height", &camera->height, err)
                   ? -1
                   : 0;
    }
}

/* v from x y z at x y z up x y z angle a hither h shift x y resolution w h: any order, hither and
 * shift optional. */
static int take_view(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"from",   "at",    "up",        "angle",
                                        "hither", "shift", "resolution"};
    enum { N_FIELDS = 7, HITHER = 4, SHIFT = 5 };
    int seen[N_FIELDS] = {0}, got, field;
    if (r->view_line)
        return sph_fail(err, "%s:%u: second `v`; the first is in line %u", r->lex.path,
                        r->lex.token_line, r->view_line);
    r->view_line = r->lex.token_line;
    while ((got = sph_lex_peek(&r->lex, err)) > 0) {
        for (field = 0; field < N_FIELDS; field++)
            if (!strcmp(r->lex.token, names[field])) break;
        if (field == N_FIELDS) break;
        sph_lex_take(&r->lex);
        if (seen[field]) return sph_nff_fail(r, err, names[field], "given twice");
        seen[field] = 1;
        if (take_view_field(r, field, err)) return -1;
    }
    if (got < 0) return -1;
    for (field = 0; field < N_FIELDS; field++)
        if (!seen[field] && field != HITHER && field != SHIFT)
            return sph_fail(err, "%s:%u: `v`: `%s` is missing", r->lex.path, r->view_line,
                            names[field]);
    char where[sizeof r->scene->path + 16];
    snprintf(where, sizeof where, "%s:%u", r->scene->path, r->view_line);
    return sph_camera_check(&r->scene->camera, where, err);
}

/* l x y z [red green blue] */
int sph_nff_take_light(struct sph_reader *r, struct sph_error *err) {
    struct sph_vec pos;
    double rgb[3] = {1, 1, 1};
    int n = r->scene->n_lights;
    uint32_t line = r->lex.token_line;
    if (n == SPH_MAX_LIGHTS)
        return sph_fail(err, "%s:%u: more than %d lights", r->lex.path, r->lex.token_line,
                        SPH_MAX_LIGHTS);
    if (sph_nff_vec(r, "l", &pos, err)) return -1;
    int got = sph_nff_more(r, "l", sph_nff_colour, 3, rgb, err);
    if (got < 0) return -1;
    r->plain[n] = !got;
    for (int i = 0; i < 3; i++)
        if (rgb[i] < 0)
            return sph_fail(err, "%s:%u: `l`: %s %g is negative", r->lex.path, r->lex.token_line,
                            sph_nff_colour[i], rgb[i]);
    if (sph_scene_add_light(r->scene, pos, rgb[0], rgb[1], rgb[2], err)) return -1;
    r->scene->lights[n].line = line;
    return 0;
}

/* move dx dy dz [grow cx cy cz], or still */
static int take_move(struct sph_reader *r, struct sph_error *err) {
    static const char *const names[] = {"grow", "x of its middle", "y of its middle",
                                        "z of its middle"};
    struct sph_motion m = {.line = r->lex.token_line};
    double grow[4] = {0};
    if (sph_nff_vec(r, "move", &m.step, err) || sph_nff_more(r, "move", names, 4, grow, err) < 0)
        return -1;
    m.grow = grow[0];
    m.about = sph_vec_of(grow[1], grow[2], grow[3]);
    if (sph_scene_add_motion(r->scene, &m, err)) return -1;
    r->motion = r->scene->n_motions;
    return 0;
}

static int take_still(struct sph_reader *r, struct sph_error *err) {
    (void)err;
    r->motion = 0;
    return 0;
}

/* fly n x y z x y z: eye, and what it looks at, at frame n */
static int take_fly(struct sph_reader *r, struct sph_error *err) {
    struct sph_flight f = {.line = r->lex.token_line};
    double frame;
    if (sph_lex_number(&r->lex, "fly", "frame", &frame, err)) return -1;
    if (!(frame >= 1 && frame <= SPH_MAX_FRAME && frame == floor(frame)))
        return sph_fail(err, "%s:%u: `fly`: frame %g is not a whole number of 1 to %u", r->lex.path,
                        r->lex.token_line, frame, SPH_MAX_FRAME);
    f.frame = (uint32_t)frame;
    return sph_nff_vec(r, "fly", &f.from, err) || sph_nff_vec(r, "fly", &f.at, err) ||
                   sph_scene_add_flight(r->scene, &f, err)
               ? -1
               : 0;
}

static int take_background(struct sph_reader *r, struct sph_error *err) {
    return take_colour_once(r, "b", &r->background_line, r->scene->background, err);
}

static int take_ambient(struct sph_reader *r, struct sph_error *err) {
    return take_colour_once(r, "ambient", &r->ambient_line, r->scene->ambient, err);
}

/* Records that add no primitives. */
static const struct sph_nff_word words[] = {{"f", sph_nff_take_f, SPH_READ_MATERIAL},
                                            {"fm", sph_nff_take_fm, SPH_READ_MATERIAL},
                                            {"texture", sph_nff_take_texture, SPH_READ_WORD},
                                            {"shading", sph_nff_take_shading, SPH_READ_WORD},
                                            {"shadows", sph_nff_take_shadows, SPH_READ_WORD},
                                            {"move", take_move, SPH_READ_WORD},
                                            {"still", take_still, SPH_READ_WORD},
                                            {"fly", take_fly, SPH_READ_WORD},
                                            {"l", sph_nff_take_light, SPH_READ_LIGHT},
                                            {"v", take_view, SPH_READ_CAMERA},
                                            {"b", take_background, SPH_READ_COLOUR},
                                            {"ambient", take_ambient, SPH_READ_COLOUR}};
enum { N_WORDS = sizeof words / sizeof *words };

int sph_nff_take_record(struct sph_reader *r, struct sph_error *err) {
    uint32_t line = r->lex.token_line, facets = r->scene->n_facets;
    const struct sph_nff_word *word = sph_prim_word(r->lex.token);
    for (int i = 0; i < N_WORDS && !word; i++)
        if (!strcmp(r->lex.token, words[i].word)) word = &words[i];
    sph_lex_take(&r->lex);
    r->ended = 0;
    if (!word) return sph_nff_skip(r, err);
    if (word->take(r, err) || (!r->ended && sph_nff_note(r, word->kind, line, err))) return -1;
    sph_nff_mark(r, facets, r->kind);
    return 0;
}

/* A record, and the motion of the primitives that it added. */
static int take_moving(struct sph_reader *r, struct sph_error *err) {
    uint32_t sphere = r->scene->n_spheres, facet = r->scene->n_facets;
    if (sph_nff_take_record(r, err)) return -1;
    for (; sphere < r->scene->n_spheres; sphere++)
        r->scene->spheres[sphere].motion = r->motion;
    for (; facet < r->scene->n_facets; facet++)
        r->scene->facets[facet].motion = r->motion;
    return 0;
}

void sph_nff_start(struct sph_reader *r, struct sph_scene *scene,
                   const struct sph_read_options *options) {
    r->scene = scene;
    scene->ledger.strict = options && options->strict;
    scene->allow_paths = options && options->allow_paths;
    r->skip = options && options->skip_unsupported;
    r->round = options && options->round > 0 ? options->round : SPH_FRUSTUM_ROUND;
}

int sph_nff_finish(struct sph_reader *r, struct sph_error *err) {
    struct sph_scene *scene = r->scene;
    if (!r->view_line) return sph_fail(err, "%s: no camera (`v`)", r->lex.path);
    if (sph_scene_check_flights(scene, err)) return -1;
    for (int i = 0; i < scene->n_lights; i++)
        for (int k = 0; k < 3 && r->plain[i]; k++)
            scene->lights[i].rgb[k] = 1 / sqrt(scene->n_lights);
    return sph_scene_drop_twice(scene, SPH_READ_SPHERE_TWICE, err);
}

/* The scenes of a file: what stands before the first `scene` is part of each. */
struct sections {
    const char *wanted; /* NULL: the file has one scene */
    uint32_t line;      /* of the first word that was read, 0: none */
    int found, passes;  /* the wanted one was met; the one that is read is another */
};

/* Takes the next word, or passes it: `scene NAME` at the start of a line begins another scene. 1 if
 * a record of the wanted one is next, 0 if not, -1 with a message. */
static int take_section(struct sph_reader *r, struct sections *s, struct sph_error *err) {
    char name[SPH_LEX_TOKEN];
    int starts = r->lex.token_line != s->line;
    s->line = r->lex.token_line;
    if (!starts || strcmp(r->lex.token, "scene") != 0) {
        if (s->passes) sph_lex_take(&r->lex);
        return !s->passes;
    }
    sph_lex_take(&r->lex);
    if (sph_lex_name(&r->lex, "scene", "name", name, sizeof name, err) < 0) return -1;
    if (!s->wanted)
        return sph_fail(err, "%s:%u: there are several scenes: say %s:%s for this one", r->lex.path,
                        s->line, r->lex.path, name);
    s->passes = strcmp(name, s->wanted) != 0;
    if (!s->passes && s->found++)
        return sph_fail(err, "%s:%u: second scene `%s`", r->lex.path, s->line, name);
    return 0;
}

int sph_nff_read(FILE *file, const char *path, const char *section,
                 const struct sph_read_options *options, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_reader r = {.skip = 0};
    struct sections s = {.wanted = section};
    int got, bad = 0;
    memset(scene, 0, sizeof *scene);
    sph_nff_start(&r, scene, options);
    sph_scene_set_path(scene, path);
    if (section) snprintf(scene->name, sizeof scene->name, "%s", section);
    sph_lex_begin(&r.lex, file, path);
    r.lex.progress = options ? options->progress : NULL;
    while (!bad && (got = sph_lex_peek(&r.lex, err)) != 0) {
        if (got > 0) got = take_section(&r, &s, err);
        bad = got < 0 || (got && take_moving(&r, err)) ? -1 : 0;
    }
    sph_lex_close(&r.lex);
    if (!bad && !s.line) bad = sph_fail(err, "%s: the file is empty", path);
    if (!bad && section && !s.found) bad = sph_fail(err, "%s: has no scene `%s`", path, section);
    if (!bad) bad = sph_nff_finish(&r, err);
    if (!bad && options) bad = sph_scene_move(scene, options->at, err);
    if (!bad) bad = sph_scene_nest(scene, err);
    if (bad) sph_scene_free(scene);
    return bad;
}
