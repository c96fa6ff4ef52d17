/* load.c - a mesh through assimp: triangles, materials, points; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <assimp/cimport.h>
#include <assimp/cfileio.h>
#include <assimp/scene.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/number.h"
#include "scene/affine.h"
#include "scene/assimp/gltf.h"
#include "scene/edit.h"
#include "scene/polygon.h"
#include "scene/record.h"

#define GREY 0.8 /* of what has no material */

/* Faces of one material and colour at their corners have one material of the scene. */
struct painted {
    uint32_t key[2]; /* of assimp's material, + 1; the colour, 8 bits each */
    uint32_t material;
};

struct load {
    const char *path;
    enum sph_file_kind kind;
    struct sph_scene *scene;
    const struct aiScene *from;
    struct sph_gltf gltf; /* of glTF */
    struct sph_mesh_lines lines;
    uint32_t face, n_groups; /* faces and groups so far */
    struct sph_look *looks;  /* of assimp's materials */
    uint32_t *textures;      /* of them: index + 1 */
    struct painted *painted;
    size_t places, n_painted; /* of painted: a power of two */
};

/* ---- files: under a name whose ending says what is in them ---- */

static const char *fake_name(enum sph_file_kind kind) {
    return kind == SPH_FILE_OBJ   ? "sphaera-mesh.obj"
           : kind == SPH_FILE_PLY ? "sphaera-mesh.ply"
           : kind == SPH_FILE_STL ? "sphaera-mesh.stl"
           : kind == SPH_FILE_GLB ? "sphaera-mesh.glb"
                                  : "sphaera-mesh.gltf";
}

static size_t read_file(struct aiFile *f, char *to, size_t size, size_t n) {
    return fread(to, size, n, (FILE *)f->UserData);
}

static size_t write_file(struct aiFile *f, const char *from, size_t size, size_t n) {
    (void)f, (void)from, (void)size, (void)n;
    return 0;
}

static size_t tell_file(struct aiFile *f) {
    long at = ftell((FILE *)f->UserData);
    return at < 0 ? 0 : (size_t)at;
}

static size_t size_of_file(struct aiFile *f) {
    FILE *file = (FILE *)f->UserData;
    long at = ftell(file), size = fseek(file, 0, SEEK_END) ? 0 : ftell(file);
    fseek(file, at, SEEK_SET);
    return size < 0 ? 0 : (size_t)size;
}

static enum aiReturn seek_file(struct aiFile *f, size_t by, enum aiOrigin from) {
    int whence = from == aiOrigin_SET ? SEEK_SET : from == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
    return fseek((FILE *)f->UserData, (long)by, whence) ? aiReturn_FAILURE : aiReturn_SUCCESS;
}

static void flush_file(struct aiFile *f) {
    (void)f;
}

static struct aiFile *open_file(struct aiFileIO *io, const char *name, const char *mode) {
    const struct load *l = (const struct load *)io->UserData;
    const char *slash = strrchr(name, '/');
    char path[512];
    int whole = !strcmp(slash ? slash + 1 : name, fake_name(l->kind));
    if (whole)
        snprintf(path, sizeof path, "%s", l->path);
    else if (sph_mesh_beside(l->scene, name, slash ? slash + 1 : name, path, sizeof path))
        return NULL;
    FILE *file = strchr(mode, 'w')        ? NULL
                 : whole && l->lines.text ? fmemopen(l->lines.text, l->lines.size, "r")
                                          : sph_input_open(path, SPH_INPUT_ANY, NULL);
    struct aiFile *f = file ? calloc(1, sizeof *f) : NULL;
    if (!f) {
        if (file) fclose(file);
        return NULL;
    }
    *f = (struct aiFile){read_file, write_file, tell_file,   size_of_file,
                         seek_file, flush_file, (char *)file};
    return f;
}

static void close_file(struct aiFileIO *io, struct aiFile *f) {
    (void)io;
    fclose((FILE *)f->UserData);
    free(f);
}

static int import(struct load *l, struct sph_error *err) {
    char name[600];
    const char *slash = strrchr(l->path, '/');
    struct aiFileIO io = {open_file, close_file, (char *)l};
    snprintf(name, sizeof name, "%.*s%s", slash ? (int)(slash - l->path) + 1 : 0, l->path,
             fake_name(l->kind));
    l->from = aiImportFileEx(name, 0, &io);
    if (l->from && l->from->mRootNode) return 0;
    const char *why = aiGetErrorString();
    return sph_fail(err, "%s: %.300s", l->path, *why ? why : "assimp finds nothing in it");
}

/* ---- materials ---- */

static double real(const struct aiMaterial *m, const char *key, double otherwise) {
    ai_real v;
    unsigned n = 1;
    return aiGetMaterialFloatArray(m, key, 0, 0, &v, &n) == aiReturn_SUCCESS && n == 1 ? (double)v
                                                                                       : otherwise;
}

/* A colour within 0..1; the mean of its channels. */
static double colour(struct load *l, const struct aiMaterial *m, const char *key, double rgb[3],
                     int *limited) {
    struct aiColor4D c = {0, 0, 0, 1};
    (void)l;
    if (aiGetMaterialColor(m, key, 0, 0, &c) != aiReturn_SUCCESS) return -1;
    const double from[3] = {(double)c.r, (double)c.g, (double)c.b};
    for (int i = 0; i < 3; i++) {
        rgb[i] = from[i] > 0 ? fmin(from[i], 1) : 0;
        *limited |= rgb[i] != from[i];
    }
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

static int note(struct load *l, enum sph_read kind, uint64_t n, uint32_t line,
                struct sph_error *err) {
    return sph_ledger_add(&l->scene->ledger, kind, n, l->path, line, 0, err);
}

/* Of MTL: Kd, Ks, Ns, d, Tf, Ni, illum, map_Kd. Only what `illum` says mirrors does so. */
static int look_of_mtl(struct load *l, const struct aiMaterial *m, struct sph_look *look,
                       struct sph_error *err) {
    double kd[3] = {GREY, GREY, GREY}, ks[3] = {0}, tf[3] = {1, 1, 1};
    struct aiString image;
    int limited = 0, illum = 2;
    unsigned one = 1;
    aiGetMaterialIntegerArray(m, "$mat.illum", 0, 0, &illum, &one);
    colour(l, m, "$clr.diffuse", kd, &limited);
    const double shines = colour(l, m, "$clr.specular", ks, &limited);
    const double filter = colour(l, m, "$clr.transparent", tf, &limited);
    double d = real(m, "$mat.opacity", 1), top = fmax(kd[0], fmax(kd[1], kd[2]));
    limited |= !(d >= 0 && d <= 1);
    d = d > 0 ? fmin(d, 1) : 0;
    const int glass = illum == 4 || illum == 6 || illum == 7 || illum == 9;
    const int mirror = glass || illum == 3 || illum == 5 || illum == 8;
    for (int i = 0; i < 3; i++)
        look->rgb[i] = top > 0 ? kd[i] / top : 0;
    look->trans = d < 1 ? 1 - d : glass && filter < 1 ? filter : 0;
    look->kd = top * d;
    look->shine = real(m, "$mat.shininess", 0);
    look->ks = shines > 0 && look->shine > 0 ? shines : 0;
    look->kr = mirror && shines > 0 ? shines : 0;
    look->ior = real(m, "$mat.refracti", 1);
    if (limited && note(l, SPH_READ_PART_LIMITED, 1, 0, err)) return -1;
    if (((look->ks > 0 || look->kr > 0) && (ks[0] != ks[1] || ks[0] != ks[2])) ||
        (look->trans > 0 && (tf[0] != tf[1] || tf[0] != tf[2]))) {
        if (note(l, SPH_READ_PART_MEAN, 1, 0, err)) return -1;
    }
    if (aiGetMaterialString(m, "$tex.file", aiTextureType_DIFFUSE, 0, &image) == aiReturn_SUCCESS &&
        sph_mesh_beside(l->scene, l->path, image.data, look->image, sizeof look->image))
        look->image[0] = 0; /* it was noted, or refused */
    return 0;
}

static int is_default(const struct aiMaterial *m) {
    struct aiString name;
    return aiGetMaterialString(m, "?mat.name", 0, 0, &name) == aiReturn_SUCCESS &&
           !strcmp(name.data, "DefaultMaterial");
}

static int take_texture(struct load *l, unsigned i, struct sph_error *err) {
    struct sph_texture t = {.repeat = {1, 1}};
    snprintf(t.path, sizeof t.path, "%s", l->looks[i].image);
    for (uint32_t k = 0; k < l->scene->n_textures && !l->textures[i]; k++)
        if (!strcmp(l->scene->textures[k].path, t.path)) l->textures[i] = k + 1;
    if (l->textures[i]) return 0;
    if (sph_scene_add_texture(l->scene, &t, err)) return -1;
    l->textures[i] = l->scene->n_textures;
    return 0;
}

static int take_materials(struct load *l, struct sph_error *err) {
    unsigned n = l->from->mNumMaterials;
    l->looks = calloc((size_t)n + 1, sizeof *l->looks);
    l->textures = calloc((size_t)n + 1, sizeof *l->textures);
    if (!l->looks || !l->textures) return sph_fail(err, "%s: no memory", l->path);
    for (unsigned i = 0; i < n; i++) {
        struct sph_look *k = &l->looks[i];
        *k = (struct sph_look){
            .rgb = {1, 1, 1}, .kd = GREY, .ior = 1, .place = {{1, 0, 0}, {0, 1, 0}}};
        int gltf = l->gltf.root != NULL;
        int bad = gltf ? sph_gltf_look(&l->gltf, i, k, l->scene, err)
                  : l->kind == SPH_FILE_OBJ && !is_default(l->from->mMaterials[i])
                      ? look_of_mtl(l, l->from->mMaterials[i], k, err)
                      : 0;
        if (bad || (k->image[0] && take_texture(l, i, err))) return -1;
    }
    return 0;
}

/* The machine's material of a look: Whitted's sum, unless it is matt. */
static int put_material(struct load *l, const struct sph_look *k, const double rgb[3],
                        struct sph_error *err) {
    const double one = SPH_INDEX_ONE;
    struct sph_material m = {
        .kd = k->kd, .ks = k->ks, .shine = k->shine, .trans = k->trans, .ior = k->ior};
    for (int i = 0; i < 3; i++)
        m.rgb[i] = k->rgb[i] * rgb[i];
    if (m.ks > 0 || m.trans > 0 || k->kr > 0)
        m.sum = (struct sph_sum){.on = 1, .ka = k->kd, .kr = k->kr};
    if (m.ks > 0) m.shine = fmin(fmax(m.shine, SPH_SHINE_MIN), SPH_SHINE_MAX);
    if (m.ks > 0 && m.shine != k->shine && note(l, SPH_READ_SHINE_LIMITED, 1, 0, err)) return -1;
    m.ior = fmin(fmax(m.ior, SPH_INDEX_MIN / one), SPH_INDEX_MAX / one);
    if (k->ior == 0) m.ior = 1;
    if (m.trans > 0 && m.ior != k->ior && note(l, SPH_READ_INDEX_LIMITED, 1, 0, err)) return -1;
    return sph_scene_add_material(l->scene, &m, err);
}

/* Light of a colour of 8 bits; sRGB: IEC 61966-2-1. */
static double light_of(uint32_t byte, int srgb) {
    double v = byte / 255.0;
    return !srgb ? v : v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static int grow_painted(struct load *l, struct sph_error *err) {
    size_t places = l->places ? 2 * l->places : 256;
    struct painted *all = calloc(places, sizeof *all);
    if (!all) return sph_fail(err, "%s: no memory for %zu materials", l->path, places);
    for (size_t i = 0; i < l->places; i++) {
        const struct painted *p = &l->painted[i];
        size_t at = (p->key[0] * 0x9e3779b1u ^ p->key[1] * 0x85ebca6bu) & (places - 1);
        if (!p->key[0]) continue;
        while (all[at].key[0])
            at = (at + 1) & (places - 1);
        all[at] = *p;
    }
    free(l->painted);
    l->painted = all, l->places = places;
    return 0;
}

/* The scene's material of assimp's one and a colour, 0xbbggrr. */
static int paint(struct load *l, unsigned material, uint32_t rgb, uint32_t *to,
                 struct sph_error *err) {
    const uint32_t key[2] = {material + 1, rgb};
    if (2 * l->n_painted >= l->places && grow_painted(l, err)) return -1;
    size_t at = (key[0] * 0x9e3779b1u ^ key[1] * 0x85ebca6bu) & (l->places - 1);
    while (l->painted[at].key[0]) {
        if (!memcmp(l->painted[at].key, key, sizeof key)) {
            *to = l->painted[at].material;
            return 0;
        }
        at = (at + 1) & (l->places - 1);
    }
    double c[3];
    for (int i = 0; i < 3; i++)
        c[i] = light_of(rgb >> 8 * i & 255, l->lines.srgb);
    l->painted[at] = (struct painted){{key[0], key[1]}, l->scene->n_materials};
    l->n_painted++;
    *to = l->scene->n_materials;
    return put_material(l, &l->looks[material], c, err);
}

/* The mean colour of corners, white if one has none. */
static uint32_t mean_colour(const struct aiMesh *m, const unsigned *corner, unsigned n) {
    double sum[3] = {0};
    uint32_t rgb = 0;
    for (unsigned i = 0; i < n; i++) {
        const struct aiColor4D *c = m->mColors[0] ? &m->mColors[0][corner[i]] : NULL;
        if (!c || !(c->a > 0)) return 0xffffff;
        const double v[3] = {(double)c->r, (double)c->g, (double)c->b};
        for (int k = 0; k < 3; k++)
            sum[k] += v[k] > 0 ? fmin(v[k], 1) : 0;
    }
    for (int k = 0; k < 3; k++)
        rgb |= (uint32_t)lround(255 * sum[k] / n) << 8 * k;
    return rgb;
}

/* ---- faces and points ---- */

static struct sph_vec vec_of(const struct aiVector3D *v) {
    return sph_vec_of((double)v->x, (double)v->y, (double)v->z);
}

/* What a face has at a corner, in the scene's frame. */
static void put_corner(const struct load *l, const struct aiMesh *m, const struct sph_affine *a,
                       int mirrored, unsigned i, struct sph_facet *f, int k) {
    const struct sph_look *look = &l->looks[m->mMaterialIndex];
    const struct aiVector3D *st = look->coords >= 0 && look->coords < AI_MAX_NUMBER_OF_TEXTURECOORDS
                                      ? m->mTextureCoords[look->coords]
                                      : NULL;
    f->v[k] = sph_affine_point(a, vec_of(&m->mVertices[i]));
    if (f->smooth) {
        struct sph_vec n = sph_affine_normal(a, vec_of(&m->mNormals[i]));
        f->n[k] = mirrored ? sph_vec_of(-n.x, -n.y, -n.z) : n;
    }
    if (!st || !f->texture) return;
    const double s = (double)st[i].x, t = 1 - (double)st[i].y; /* down from the highest row */
    for (int c = 0; c < 2; c++)
        f->st[k][c] = look->place[c][0] * s + look->place[c][1] * t + look->place[c][2];
}

/* "file:line: what", or "file: face 7: what". */
static int fail_face(const struct load *l, const struct sph_facet *f, const char *what,
                     struct sph_error *err) {
    char place[SPH_PLACE];
    return sph_fail(err, "%s: %.300s",
                    sph_record_place(place, l->path, f->line, "face", l->face - 1), what);
}

static int check_corner(const struct load *l, const struct sph_facet *f, int k,
                        struct sph_error *err) {
    if (sph_vec_small(f->v[k]) && fabs(f->st[k][0]) <= SPH_NUMBER_MAX &&
        fabs(f->st[k][1]) <= SPH_NUMBER_MAX)
        return 0;
    return fail_face(l, f, "a corner is not a number, or too large", err);
}

/* A face as triangles, as `p` and `pp` of NFF are. */
static int take_face(struct load *l, const struct aiMesh *m, const struct aiFace *face,
                     const struct sph_affine *a, int mirrored, struct sph_error *err) {
    struct sph_vec corner[SPH_MAX_CORNERS];
    int index[SPH_MAX_CORNERS - 2][3];
    unsigned n = face->mNumIndices;
    struct sph_error why = {""};
    double bent = 0;
    struct sph_facet f = {.kind = SPH_TRIANGLE, .texture = l->textures[m->mMaterialIndex]};
    if (l->face < l->lines.n && l->from->mNumMeshes == 1) f.line = l->lines.face[l->face];
    l->face++;
    for (unsigned i = 0; i < n; i++)
        if (face->mIndices[i] >= m->mNumVertices)
            return fail_face(l, &f, "an index leads nowhere", err);
    if (n > SPH_MAX_CORNERS) return fail_face(l, &f, "more than 1024 corners", err);
    for (unsigned i = 0; i < n; i++)
        corner[i] = sph_affine_point(a, vec_of(&m->mVertices[face->mIndices[i]]));
    int count = sph_polygon_cut(corner, (int)n, index, &bent, &why);
    if (count < 0) return fail_face(l, &f, why.text, err);
    if (!count) return note(l, SPH_READ_NO_AREA, 1, f.line, err);
    f.read = bent > 0 ? SPH_READ_BENT : n > 3 ? SPH_READ_POLYGON : SPH_READ_TRIANGLE;
    uint32_t rgb = mean_colour(m, face->mIndices, n);
    if (paint(l, m->mMaterialIndex, rgb, &f.material, err)) return -1;
    const int smooth = m->mNormals && l->kind != SPH_FILE_STL;
    for (int i = 0; i < count; i++) {
        f.smooth = smooth;
        for (int k = 0; k < 3; k++) {
            int from = index[i][mirrored && k ? 3 - k : k];
            put_corner(l, m, a, mirrored, face->mIndices[from], &f, k);
            if (check_corner(l, &f, k, err)) return -1;
        }
        for (int c = 0; c < 2; c++) { /* whole repeats say nothing */
            double whole = floor(fmin(f.st[0][c], fmin(f.st[1][c], f.st[2][c])));
            for (int k = 0; k < 3; k++)
                f.st[k][c] -= whole;
        }
        f.smooth = smooth && sph_smooth_given(f.n) && sph_vec_small(f.n[0]) &&
                   sph_vec_small(f.n[1]) && sph_vec_small(f.n[2]);
        f.group = l->n_groups;
        if (sph_scene_add_facet(l->scene, &f, err)) return -1;
        if (bent > 0 || i == count - 1) l->n_groups++;
    }
    if (m->mColors[0] && rgb != 0xffffff && note(l, SPH_READ_CORNER_COLOURS, 1, f.line, err))
        return -1;
    return note(l, (enum sph_read)f.read, 1, f.line, err);
}

static int take_mesh(struct load *l, const struct aiMesh *m, const struct sph_affine *a,
                     struct sph_error *err) {
    const double *x = a->m[0], *y = a->m[1], *z = a->m[2];
    const int mirrored = x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
                             x[2] * (y[0] * z[1] - y[1] * z[0]) <
                         0;
    uint32_t parts = 0;
    if (m->mMaterialIndex >= l->from->mNumMaterials || !m->mVertices)
        return sph_fail(err, "%s: a mesh without corners or material", l->path);
    for (unsigned i = 0; i < m->mNumFaces; i++) {
        if (m->mFaces[i].mNumIndices < 3) {
            parts++;
            continue;
        }
        if (take_face(l, m, &m->mFaces[i], a, mirrored, err)) return -1;
    }
    return note(l, SPH_READ_LINE, parts, l->lines.part, err);
}

/* Every node in turn. */
static int take_node(struct load *l, const struct aiNode *node, const struct sph_affine *above,
                     int (*take)(struct load *, const struct aiMesh *, const struct sph_affine *,
                                 struct sph_error *),
                     struct sph_error *err) {
    const struct aiMatrix4x4 *t = &node->mTransformation;
    const struct sph_affine own = {{{(double)t->a1, (double)t->a2, (double)t->a3, (double)t->a4},
                                    {(double)t->b1, (double)t->b2, (double)t->b3, (double)t->b4},
                                    {(double)t->c1, (double)t->c2, (double)t->c3, (double)t->c4}}};
    const struct sph_affine a = sph_affine_after(above, &own);
    for (unsigned i = 0; i < node->mNumMeshes; i++)
        if (take(l, l->from->mMeshes[node->mMeshes[i]], &a, err)) return -1;
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (take_node(l, node->mChildren[i], &a, take, err)) return -1;
    return 0;
}

static int take_points(struct load *l, const struct aiMesh *m, const struct sph_affine *a,
                       struct sph_error *err) {
    if (m->mMaterialIndex >= l->from->mNumMaterials || !m->mVertices)
        return sph_fail(err, "%s: points without places or material", l->path);
    for (unsigned i = 0; i < m->mNumVertices; i++) {
        uint32_t material, rgb = mean_colour(m, &i, 1);
        struct sph_vec at = sph_affine_point(a, vec_of(&m->mVertices[i]));
        if (!sph_vec_small(at))
            return sph_fail(err, "%s: point %u: not a number, or too large", l->path, i);
        if (paint(l, m->mMaterialIndex, rgb, &material, err) ||
            note(l, SPH_READ_SPHERE, 1, 0, err) ||
            sph_scene_add_sphere(l->scene, at, 1, material, 0, err))
            return -1;
    }
    return 0;
}

/* ---- the whole ---- */

/* Whether there is a surface; else points become spheres. */
static int has_faces(const struct aiScene *from) {
    for (unsigned i = 0; i < from->mNumMeshes; i++)
        for (unsigned k = 0; k < from->mMeshes[i]->mNumFaces; k++)
            if (from->mMeshes[i]->mFaces[k].mNumIndices > 2) return 1;
    return 0;
}

/* Middle and half the diagonal of a box around everything. */
static double bounds(const struct sph_scene *scene, struct sph_vec *middle) {
    struct sph_vec low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint64_t i = 0; i < scene->n_spheres + 3ull * scene->n_facets; i++) {
        uint64_t k = i - scene->n_spheres;
        struct sph_vec p =
            i < scene->n_spheres ? scene->spheres[i].ctr : scene->facets[k / 3].v[k % 3];
        low = sph_vec_of(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = sph_vec_of(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    *middle = sph_vec_of((low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2);
    return sph_vec_length(sph_vec_sub(high, low)) / 2;
}

static int check(struct load *l, int skip, struct sph_error *err) {
    if (l->kind == SPH_FILE_OBJ) return sph_obj_check(l->path, skip, l->scene, &l->lines, err);
    if (l->kind == SPH_FILE_PLY) return sph_ply_check(l->path, l->scene, &l->lines, err);
    if (l->kind == SPH_FILE_STL) return sph_stl_check(l->path, l->scene, &l->lines, err);
    return sph_gltf_open(&l->gltf, l->path, err) || sph_gltf_check(&l->gltf, skip, l->scene, err);
}

static int load(struct load *l, const struct sph_import_options *o, struct sph_error *err) {
    static const struct sph_affine none = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    struct sph_scene *scene = l->scene;
    struct sph_vec middle;
    if (check(l, o->skip, err) || import(l, err) || take_materials(l, err) ||
        take_node(l, l->from->mRootNode, &none, has_faces(l->from) ? take_mesh : take_points, err))
        return -1;
    if (l->lines.n && l->lines.n != l->face)
        return sph_fail(err, "%s: assimp finds %u of %u faces", l->path, l->face, l->lines.n);
    double radius = bounds(scene, &middle);
    /* As large as their mean distance would be if they were spread over a square. */
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        scene->spheres[i].rad = o->radius > 0 ? o->radius
                                : radius > 0  ? radius / sqrt(scene->n_spheres)
                                              : 1;
    if (l->gltf.root) return sph_gltf_place(&l->gltf, o->camera, middle, radius, scene, err);
    return o->camera
               ? sph_fail(err, "%s: --camera %.80s: the file has no cameras", l->path, o->camera)
               : 0;
}

/* The object is loaded by name. */
__attribute__((visibility("default"))) int sph_mesh_load(const char *path, enum sph_file_kind kind,
                                                         const struct sph_import_options *options,
                                                         struct sph_scene *scene,
                                                         struct sph_error *err) {
    struct load l = {.path = path, .kind = kind, .scene = scene};
    int bad = load(&l, options, err);
    if (l.from) aiReleaseImport(l.from);
    sph_gltf_close(&l.gltf);
    sph_mesh_lines_free(&l.lines);
    free(l.painted);
    free(l.textures);
    free(l.looks);
    return bad ? -1 : 0;
}
