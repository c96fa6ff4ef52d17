/* scene.c - scenes of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "scene/generate.h"
#include "scene/motion.h"
#include "sphaera/opaque.h"

/* text NULL: the file called name, or KIND:N. */
static int make(const char *text, size_t length, const char *name, uint32_t at,
                sphaera_scene **scene, sphaera_error *error) {
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_read_options options = {.at = at};
    *scene = NULL;
    sphaera_scene *made = malloc(sizeof *made);
    int rc = !made ? sph_fail(&err, "%.400s: no memory for a scene", name)
             : at > SPH_MAX_FRAME
                 ? sph_fail(&err, "%.400s: frame %u, the last is %d", name, at, SPH_MAX_FRAME)
             : text ? sph_scene_parse(text, length, name, &options, &made->scene, &err)
                    : sph_scene_find(name, &options, &made->scene, &err);
    if (!rc) {
        *scene = made;
        return 0;
    }
    free(made);
    return sph_api_failed(&err, error);
}

int sphaera_scene_read(const char *path, uint32_t at, sphaera_scene **scene, sphaera_error *error) {
    if (sph_api_null(path, "path", error) || sph_api_null(scene, "scene", error)) return -1;
    return make(NULL, 0, path, at, scene, error);
}

int sphaera_scene_parse(const char *text, size_t length, const char *name, uint32_t at,
                        sphaera_scene **scene, sphaera_error *error) {
    if (sph_api_null(text, "text", error) || sph_api_null(name, "name", error) ||
        sph_api_null(scene, "scene", error))
        return -1;
    return make(text, length, name, at, scene, error);
}

int sphaera_scene_strict(sphaera_scene *scene, sphaera_error *error) {
    if (sph_api_null(scene, "scene", error)) return -1;
    struct sph_error err = {""};
    scene->scene.ledger.strict = 1;
    return sph_ledger_check(&scene->scene.ledger, &err) ? sph_api_failed(&err, error) : 0;
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
