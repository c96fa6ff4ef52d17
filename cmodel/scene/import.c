/* import.c - see import.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/import.h"

#include <string.h>

#include "common/packed.h"
#include "scene/edit.h"
#include "scene/mesh.h"
#include "scene/pdb_frame.h"
#include "scene/points.h"
#include "scene/vector.h"

static int is_mesh(enum sph_file_kind kind) {
    return kind == SPH_FILE_OBJ || kind == SPH_FILE_PLY || kind == SPH_FILE_STL ||
           kind == SPH_FILE_GLTF || kind == SPH_FILE_GLB;
}

int sph_importable(enum sph_file_kind kind) {
    return is_mesh(kind) || kind == SPH_FILE_PDB || kind == SPH_FILE_CIF || kind == SPH_FILE_XYZ ||
           kind == SPH_FILE_CSV;
}

static int read_atoms(FILE *file, enum sph_file_kind kind, const struct sph_import_options *o,
                      struct sph_scene *scene, struct sph_error *err) {
    struct sph_elements elements;
    struct sph_atoms atoms = {0};
    int (*const read)(FILE *, struct sph_atoms *, struct sph_scene *, struct sph_error *) =
        kind == SPH_FILE_CIF   ? sph_cif_read
        : kind == SPH_FILE_XYZ ? sph_xyz_read
                               : sph_pdb_read;
    int bad = sph_elements_read(o->elements_path ? o->elements_path : SPH_ELEMENTS_PATH, &elements,
                                err) ||
              read(file, &atoms, scene, err) || sph_atoms_put(&atoms, &elements, o, scene, err);
    sph_atoms_free(&atoms);
    return bad ? -1 : 0;
}

int sph_import(const char *path, enum sph_file_kind kind, const struct sph_import_options *options,
               struct sph_scene *scene, struct sph_error *err) {
    struct sph_import_options o = {0};
    if (options) o = *options;
    memset(scene, 0, sizeof *scene);
    scene->ledger.strict = o.strict;
    scene->allow_paths = o.allow_paths;
    sph_scene_set_path(scene, path);
    scene->camera.width = o.width || o.height ? o.width : 320;
    scene->camera.height = o.width || o.height ? o.height : 180;
    FILE *file = sph_input_text(path, err);
    if (!file) return -1;
    int mesh = is_mesh(kind);
    if (!mesh && o.camera) {
        fclose(file);
        return sph_fail(err, "%s: --camera %.80s: only glTF has cameras to choose from", path,
                        o.camera);
    }
    int bad = mesh                   ? sph_mesh_read(path, kind, &o, scene, err)
              : kind == SPH_FILE_CSV ? sph_csv_read(file, o.radius > 0 ? o.radius : 1, scene, err)
                                     : read_atoms(file, kind, &o, scene, err);
    fclose(file);
    if (!bad && !scene->n_spheres && !scene->n_facets)
        bad = sph_fail(err, "%s: no %s", path, mesh ? "faces or points" : "points");
    if (!bad && (mesh || kind == SPH_FILE_CSV))
        bad = sph_scene_drop_twice(scene, SPH_READ_SPHERE_TWICE, err);
    if (!bad && (scene->camera.width < 1 || scene->camera.height < 1))
        bad = sph_fail(err, "%s: resolution %d x %d", path, scene->camera.width,
                       scene->camera.height);
    if (!bad) {
        if (mesh)
            sph_scene_frame_mesh(scene, o.up ? o.up : kind == SPH_FILE_STL ? 'z' : 'y');
        else
            sph_scene_frame(scene);
        bad = sph_camera_check(&scene->camera, path, err);
        for (int l = 0; l < scene->n_lights && !bad; l++)
            if (!sph_vec_small(scene->camera.from) || !sph_vec_small(scene->lights[l].pos))
                bad = sph_fail(err, "%s: camera: what the file has is too large to be looked at",
                               path);
    }
    if (bad) sph_scene_free(scene);
    return bad ? -1 : 0;
}
