/* aff_read.c - files of the Animated File Format, and what they include; see aff.h, aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/aff.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "scene/aff_reader.h"
#include "scene/inside.h"
#include "scene/nesting.h"

int sph_aff_is(const char *path) {
    size_t length = strlen(path);
    return length > 4 && !strcasecmp(path + length - 4, ".aff");
}

static int take_file(struct sph_aff *a, const char *path, struct sph_error *err);

/* Notes a file that the scene includes. */
static int keep_path(struct sph_aff *a, const char *path, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    for (uint32_t i = 0; i < scene->n_files; i++)
        if (!strcmp(scene->files[i], path)) return 0;
    if (sph_aff_room(a, &scene->files, scene->n_files, sizeof *scene->files, err)) return -1;
    scene->files[scene->n_files] = strdup(path);
    if (!scene->files[scene->n_files]) return sph_fail(err, "%s: no memory", path);
    scene->n_files++;
    return 0;
}

/* Reads an included file in place of the one that is read. */
static int include(struct sph_aff *a, const char *path, struct sph_error *err) {
    uint32_t line = a->r.lex.token_line;
    struct sph_error why = {""};
    if (a->depth == SPH_AFF_DEPTH || a->includes++ == SPH_AFF_INCLUDES)
        return sph_fail(err, "%s:%u: `i`: more than %d files %s", a->r.lex.path, line,
                        a->depth == SPH_AFF_DEPTH ? SPH_AFF_DEPTH : SPH_AFF_INCLUDES,
                        a->depth == SPH_AFF_DEPTH ? "one within another" : "in all");
    for (int i = 0; i < a->depth; i++)
        if (!strcmp(a->open[i], path))
            return sph_fail(err, "%s:%u: `i`: %s includes itself", a->r.lex.path, line, path);
    if (keep_path(a, path, err)) return -1;
    struct sph_lex *outer = malloc(sizeof *outer);
    if (!outer) return sph_fail(err, "%s:%u: `i`: no memory", a->r.lex.path, line);
    *outer = a->r.lex;
    a->done += outer->taken;
    int bad = sph_lex_open(&a->r.lex, path, &why);
    if (bad)
        sph_fail(err, "%s:%u: `i`: %.300s", outer->path, line, why.text);
    else
        bad = take_file(a, path, err);
    a->r.lex = *outer;
    a->done -= outer->taken;
    sph_aff_tell_file(a);
    free(outer);
    return bad;
}

/* i level FILE: left out if its level is above that of `d` */
static int take_include(struct sph_aff *a, struct sph_error *err) {
    double level;
    char name[SPH_LEX_TOKEN + 1] = "", path[sizeof a->r.scene->path + SPH_LEX_TOKEN + 1];
    if (sph_lex_number(&a->r.lex, "i", "level of detail", &level, err) ||
        sph_aff_name(a, "i", "file", name, err))
        return -1;
    if (sph_aff_path(a->r.lex.path, name, path, sizeof path))
        return sph_nff_fail(&a->r, err, "i", "the path of the file is too long");
    if (!sph_scene_may_read(a->r.scene, path))
        return sph_fail(err, "%s:%u: `i`: %s " SPH_OUTSIDE, a->r.lex.path, a->r.lex.token_line,
                        name);
    return level > a->detail ? sph_nff_note(&a->r, SPH_READ_DETAIL, a->r.lex.token_line, err)
                             : include(a, path, err);
}

/* A record; what it adds belongs to the transform that it stands in. Cones are triangles from here
 * on: scaled, they are cones no more. */
static int take_record(struct sph_aff *a, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    uint32_t sphere = scene->n_spheres, facet = scene->n_facets, texture = scene->n_textures;
    int light = scene->n_lights;
    if (a->depth == 1) a->top_line = a->r.lex.token_line;
    int own = strcmp(a->r.lex.token, "i") != 0; /* an include has done so itself */
    if (!own) sph_lex_take(&a->r.lex);
    if (own ? sph_aff_take_word(a, err) : take_include(a, err)) return -1;
    if (scene->n_materials && !a->r.material_used)
        scene->materials[a->r.material].line = (int)a->top_line;
    for (; texture < scene->n_textures; texture++)
        scene->textures[texture].line = a->top_line;
    for (; own && sphere < scene->n_spheres; sphere++) {
        scene->spheres[sphere].motion = a->node;
        scene->spheres[sphere].line = a->top_line;
    }
    for (; own && facet < scene->n_facets; facet++) {
        scene->facets[facet].motion = a->node;
        scene->facets[facet].frustum = 0;
        scene->facets[facet].line = a->top_line;
    }
    for (; own && light < scene->n_lights; light++)
        a->lamp[light].node = a->node;
    return 0;
}

/* Reads the file that is open in the lexer up to its end, and closes it. */
static int take_file(struct sph_aff *a, const char *path, struct sph_error *err) {
    uint32_t outer = a->node;
    int got = 0, bad = 0;
    char *name = strdup(path);
    a->r.lex.path = name ? name : path;
    a->r.lex.aff = 1;
    if (!name) bad = sph_fail(err, "%s: no memory", path);
    if (name) a->open[a->depth++] = name;
    sph_aff_tell_file(a);
    while (!bad && (got = sph_lex_peek(&a->r.lex, err)) > 0) {
        if (strcmp(a->r.lex.token, "}") != 0) {
            bad = take_record(a, err);
            continue;
        }
        sph_lex_take(&a->r.lex);
        if (a->node == outer)
            bad = sph_fail(err, "%s:%u: } without {", path, a->r.lex.token_line);
        else
            a->node = a->nodes[a->node - 1].parent;
    }
    if (!bad && got < 0) bad = -1;
    if (!bad && a->node != outer)
        bad = sph_fail(err, "%s:%u: { without }", path, a->nodes[a->node - 1].line);
    sph_lex_close(&a->r.lex);
    a->done += a->r.lex.size;
    if (name) a->depth--;
    free(name);
    return bad;
}

/* The time that was asked for: frame n of `a`, or the start. */
static int time_of(const struct sph_aff *a, const struct sph_read_options *options, double *time,
                   struct sph_error *err) {
    *time = a->start;
    if (options && options->timed) *time = options->time;
    if (!options || options->timed || !options->at) return 0;
    if (!a->a_line)
        return sph_fail(err, "%s: frame %u: the scene has no animation (`a`)", a->r.scene->path,
                        options->at);
    if (options->at >= a->frames)
        return sph_fail(err, "%s: frame %u: the animation has frames 0 to %.0f", a->r.scene->path,
                        options->at, a->frames - 1);
    *time += options->at * (a->end - a->start) / (a->frames - 1);
    return 0;
}

static void close_all(struct sph_aff *a) {
    for (uint32_t i = 0; i < a->n_keys; i++)
        for (int track = 0; track < SPH_AFF_TRACKS; track++)
            free(a->keys[i].track[track].key);
    for (uint32_t i = 0; i < a->n_patches; i++)
        free(a->patches[i].at);
    free(a->keys);
    free(a->patches);
    free(a->nodes);
    free(a);
}

int sph_aff_read(const char *path, const struct sph_read_options *options, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_aff *a = calloc(1, sizeof *a);
    double time;
    memset(scene, 0, sizeof *scene);
    if (!a) return sph_fail(err, "%s: no memory", path);
    sph_scene_set_path(scene, path);
    scene->aff = 1;
    if (options) scene->read = *options, scene->read.progress = NULL;
    sph_nff_start(&a->r, scene, options);
    a->r.clear = 1;
    sph_aff_tell(a, options ? options->progress : NULL, path);
    int bad = sph_lex_open(&a->r.lex, path, err) || take_file(a, path, err);
    a->r.lex.path = scene->path;
    bad = bad || time_of(a, options, &time, err) || sph_aff_pose(a, time, err) ||
          sph_nff_finish(&a->r, err) || sph_scene_nest(scene, err);
    close_all(a);
    if (bad) sph_scene_free(scene);
    return bad ? -1 : 0;
}
