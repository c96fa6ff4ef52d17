/* scene.c - scenes of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "scene/aff.h"
#include "scene/arrays.h"
#include "scene/frustum.h"
#include "scene/generate.h"
#include "scene/motion.h"
#include "sphaera/opaque.h"

void sphaera_read_init(sphaera_read_options *options) {
    *options = (sphaera_read_options){.size = sizeof *options};
}

static int read_options(const sphaera_read_options *from, const char *name,
                        struct sph_read_options *to, struct sph_error *err) {
    if (from->size != sizeof *from)
        return sph_fail(err, "read options: not those of sphaera_read_init()");
    if (from->at > SPH_MAX_FRAME)
        return sph_fail(err, "%.400s: frame %u, the last is %d", name, from->at, SPH_MAX_FRAME);
    if (sph_api_whole("timed", from->timed, 0, 1, err) ||
        sph_api_whole("skip_unsupported", from->skip_unsupported, 0, 1, err) ||
        sph_api_whole("strict", from->strict, 0, 1, err) ||
        sph_api_whole("allow_paths", from->allow_paths, 0, 1, err) ||
        (from->timed && sph_api_real("time", from->time, -1e9, 1e9, err)) ||
        (from->round != 0 &&
         sph_api_real("round", from->round, SPH_FRUSTUM_ROUND_MIN, SPH_FRUSTUM_ROUND_MAX, err)))
        return -1;
    if (from->radius != 0 && sph_api_real("radius", from->radius, 1e-9, 1e9, err)) return -1;
    if (from->up && !strchr("xyz", from->up))
        return sph_fail(err, "up is '%c', none of x, y, z", from->up);
    if (from->timed && !sph_aff_is(name))
        return sph_fail(err, "%.400s: time is for AFF scenes; frames of others are `at`", name);
    *to = (struct sph_read_options){.skip_unsupported = from->skip_unsupported,
                                    .strict = from->strict,
                                    .allow_paths = from->allow_paths,
                                    .round = from->round,
                                    .at = from->at,
                                    .timed = from->timed,
                                    .time = from->time,
                                    .camera = from->camera,
                                    .radius = from->radius,
                                    .up = from->up};
    return 0;
}

/* text NULL: the file called name, or KIND:N. */
static int read(const char *text, size_t length, const char *name, const sphaera_read_options *from,
                struct sph_scene *scene, struct sph_error *err) {
    struct sph_read_options options;
    struct sph_api_told told = {from->progress, from->user, 0};
    const struct sph_progress progress = {sph_api_show, &told, 0, 1};
    if (read_options(from, name, &options, err)) return -1;
    if (from->progress) options.progress = &progress;
    int rc = text ? sph_scene_parse(text, length, name, &options, scene, err)
                  : sph_scene_find(name, &options, scene, err);
    if (!told.end) return rc;
    if (!rc) sph_scene_free(scene);
    *err = (struct sph_error){""};
    return sph_fail(err, "cancelled");
}

static int make(const char *text, size_t length, const char *name,
                const sphaera_read_options *options, sphaera_scene **scene, sphaera_error *error) {
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *scene = NULL;
    sphaera_scene *made = malloc(sizeof *made);
    int rc = made ? read(text, length, name, options, &made->scene, &err)
                  : sph_fail(&err, "%.400s: no memory for a scene", name);
    if (!rc) {
        *scene = made;
        return 0;
    }
    free(made);
    return sph_api_failed(&err, error);
}

int sphaera_scene_read_with(const char *path, const sphaera_read_options *options,
                            sphaera_scene **scene, sphaera_error *error) {
    sphaera_read_options defaults;
    if (sph_api_null(path, "path", error) || sph_api_null(scene, "scene", error)) return -1;
    sphaera_read_init(&defaults);
    return make(NULL, 0, path, options ? options : &defaults, scene, error);
}

int sphaera_scene_read(const char *path, uint32_t at, sphaera_scene **scene, sphaera_error *error) {
    sphaera_read_options options;
    sphaera_read_init(&options);
    options.at = at;
    return sphaera_scene_read_with(path, &options, scene, error);
}

int sphaera_scene_parse_with(const char *text, size_t length, const char *name,
                             const sphaera_read_options *options, sphaera_scene **scene,
                             sphaera_error *error) {
    sphaera_read_options defaults;
    if (sph_api_null(text, "text", error) || sph_api_null(name, "name", error) ||
        sph_api_null(scene, "scene", error))
        return -1;
    sphaera_read_init(&defaults);
    return make(text, length, name, options ? options : &defaults, scene, error);
}

int sphaera_scene_parse(const char *text, size_t length, const char *name, uint32_t at,
                        sphaera_scene **scene, sphaera_error *error) {
    sphaera_read_options options;
    sphaera_read_init(&options);
    options.at = at;
    return sphaera_scene_parse_with(text, length, name, &options, scene, error);
}

void sphaera_arrays_init(sphaera_arrays *arrays) {
    static const double white[8] = {1, 1, 1, 1, 0, 0, 0, 1};
    *arrays = (sphaera_arrays){.size = sizeof *arrays,
                               .name = "arrays",
                               .from = {0, 0, 1},
                               .up = {0, 1, 0},
                               .angle = 45,
                               .width = 320,
                               .height = 180,
                               .n_materials = 1,
                               .materials = white};
}

static struct sph_vec vec(const double v[3]) {
    return (struct sph_vec){v[0], v[1], v[2]};
}

static int make_arrays(const sphaera_arrays *a, struct sph_scene *scene, struct sph_error *err) {
    if (a->size != sizeof *a) return sph_fail(err, "arrays: not those of sphaera_arrays_init()");
    const struct {
        const char *name;
        uint32_t n;
        const double *rows;
    } arrays[] = {{"materials", a->n_materials, a->materials},
                  {"spheres", a->n_spheres, a->spheres},
                  {"triangles", a->n_triangles, a->triangles},
                  {"planes", a->n_planes, a->planes},
                  {"lights", a->n_lights, a->lights},
                  {"st", a->triangle_textures ? a->n_triangles : 0, a->st}};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        if (arrays[i].n && !arrays[i].rows)
            return sph_fail(err, "%s is NULL, n_%s is %u", arrays[i].name, arrays[i].name,
                            arrays[i].n);
    if (a->n_textures && !a->textures)
        return sph_fail(err, "textures is NULL, n_textures is %u", a->n_textures);
    if (!a->name) return sph_fail(err, "name is NULL");
    struct sph_arrays to = {.name = a->name,
                            .camera = {.from = vec(a->from),
                                       .at = vec(a->at),
                                       .up = vec(a->up),
                                       .angle = a->angle,
                                       .hither = 1,
                                       .shift = {a->shift[0], a->shift[1]},
                                       .width = a->width,
                                       .height = a->height},
                            .n_materials = a->n_materials,
                            .n_spheres = a->n_spheres,
                            .n_triangles = a->n_triangles,
                            .n_planes = a->n_planes,
                            .n_lights = a->n_lights,
                            .materials = a->materials,
                            .spheres = a->spheres,
                            .triangles = a->triangles,
                            .normals = a->normals,
                            .planes = a->planes,
                            .lights = a->lights,
                            .colours = a->light_colours,
                            .sphere_materials = a->sphere_materials,
                            .triangle_materials = a->triangle_materials,
                            .plane_materials = a->plane_materials,
                            .n_textures = a->n_textures,
                            .textures = a->textures,
                            .sphere_textures = a->sphere_textures,
                            .triangle_textures = a->triangle_textures,
                            .st = a->st};
    memcpy(to.background, a->background, sizeof to.background);
    memcpy(to.ambient, a->ambient, sizeof to.ambient);
    return sph_scene_of_arrays(&to, scene, err);
}

int sphaera_scene_make(const sphaera_arrays *arrays, sphaera_scene **scene, sphaera_error *error) {
    if (sph_api_null(arrays, "arrays", error) || sph_api_null(scene, "scene", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *scene = NULL;
    sphaera_scene *made = malloc(sizeof *made);
    int rc =
        made ? make_arrays(arrays, &made->scene, &err) : sph_fail(&err, "no memory for a scene");
    if (!rc) {
        *scene = made;
        return 0;
    }
    free(made);
    return sph_api_failed(&err, error);
}

int sphaera_scene_write(const sphaera_scene *scene, const char *path, sphaera_error *error) {
    if (sph_api_null(scene, "scene", error) || sph_api_null(path, "path", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_output out;
    int rc = sph_output_open(&out, path, &err);
    if (!rc) rc = sph_output_close(&out, sph_scene_write(&scene->scene, out.file, &err), &err);
    return rc ? sph_api_failed(&err, error) : 0;
}

void sphaera_scene_free(sphaera_scene *scene) {
    if (scene) sph_scene_free(&scene->scene);
    free(scene);
}

uint32_t sphaera_scene_spheres(const sphaera_scene *scene) {
    return scene->scene.n_spheres;
}

uint32_t sphaera_scene_facets(const sphaera_scene *scene) {
    return scene->scene.n_facets;
}

int sph_api_record(const struct sph_ledger *ledger, int number, sphaera_record *record) {
    for (int kind = 0; kind < SPH_READS; kind++) {
        const struct sph_ledger_row *row = &ledger->row[kind];
        if (!row->n || number--) continue;
        *record = (sphaera_record){sph_read_name((enum sph_read)kind),
                                   sph_read_end_name(sph_read_end((enum sph_read)kind)), row->file,
                                   row->line, row->n};
        return 0;
    }
    return -1;
}

int sphaera_scene_record(const sphaera_scene *scene, int number, sphaera_record *record) {
    return sph_api_record(&scene->scene.ledger, number, record);
}
