/* mesh.h - meshes of other programs: OBJ, PLY, STL, glTF
 * SPDX-License-Identifier: Apache-2.0
 *
 * assimp reads them (scene/assimp). It says neither in which line something stands nor what it
 * passes over, and does not look whether a file is whole: mesh_obj.c, mesh_ply.c, mesh_stl.c go
 * through the file's records before, note those that it will not give in the ledger, and refuse
 * what is wrong with file and line. Of OBJ and STL texts it gets what they write: assimp 5.2 passes
 * over a vertex one of whose numbers begins with a point, so that all after it are others, reads no
 * line that goes on in the next one, and no STL in capitals.
 */
#ifndef SPH_SCENE_MESH_H
#define SPH_SCENE_MESH_H

#include "scene/import.h"

/* Where the records of a file stand. Zeroed: not known. */
struct sph_mesh_lines {
    uint32_t *face; /* the line of each face (3 corners and more), in the order of the file */
    uint32_t n;
    uint32_t part; /* of the first line or point */
    int srgb;      /* colours at corners are bytes, which are sRGB */
    char *text;    /* what assimp reads instead of the file, NULL: the file */
    size_t size;
};
void sph_mesh_lines_free(struct sph_mesh_lines *lines);

/* The line of the next face. -1 with a message if memory is short. */
int sph_mesh_lines_add(struct sph_mesh_lines *lines, uint32_t line, struct sph_error *err);

/* Goes through the file's records: notes in scene->ledger those that assimp does not give (corners,
 * words, properties that are not used), sets *lines. -1 with "file:line: message": a number that is
 * none or above SPH_NUMBER_MAX, an index that leads nowhere, fewer records than are announced, a
 * material library or image that cannot be read. skip: leave out such libraries and images. */
int sph_obj_check(const char *path, int skip, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err);
int sph_ply_check(const char *path, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err);
int sph_stl_check(const char *path, struct sph_scene *scene, struct sph_mesh_lines *lines,
                  struct sph_error *err);

/* The path of what the file at `of`, of the scene, calls `name`: in its folder, with / for \ if
 * nothing is there otherwise. NULL, or what is wrong: it cannot be read, is too long, or the scene
 * may not read it (inside.h). */
const char *sph_mesh_beside(const struct sph_scene *scene, const char *of, const char *name,
                            char *path, size_t size);

/* ---- a text, line by line ---- */

struct sph_text {
    const char *path;
    char *bytes, *at, *end, *rest; /* the whole; what comes next; what is left of the line */
    uint32_t line;                 /* from 1 */
};

/* Reads the file whole; free with sph_text_close. -1 with a message. */
int sph_text_open(struct sph_text *text, const char *path, struct sph_error *err);
void sph_text_close(struct sph_text *text);

/* The next line, ended by LF, CRLF or CR: 1, or 0 at the end. */
int sph_text_line(struct sph_text *text);

/* The next word of the line between blanks; NULL at its end. The line is changed. */
char *sph_text_word(struct sph_text *text);

/* Takes a number. -1 with "file:line: `record`: what: ...". */
int sph_text_number(struct sph_text *text, const char *record, const char *what, double *value,
                    struct sph_error *err);

/* ---- what does the work, in an object of its own that needs assimp ---- */

/* Reads the mesh at path into an empty scene: facets, or spheres if it has points alone; materials,
 * textures, lights, the camera that is chosen (its angle is 0 if there is none). -1 with a message;
 * the caller frees the scene. */
int sph_mesh_load(const char *path, enum sph_file_kind kind,
                  const struct sph_import_options *options, struct sph_scene *scene,
                  struct sph_error *err);

/* The same in a process of its own, by the object that is loaded for it: what files do to assimp,
 * they do not to the caller. */
int sph_mesh_read(const char *path, enum sph_file_kind kind,
                  const struct sph_import_options *options, struct sph_scene *scene,
                  struct sph_error *err);

#endif
