/* gltf.c - the JSON of a glTF file: what it names, and its materials; see gltf.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/assimp/gltf.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#define DIELECTRIC 1.5 /* index of refraction, unless KHR_materials_ior says another */

/* ---- the file ---- */

static uint32_t word_at(const char *at) {
    const uint8_t *b = (const uint8_t *)at;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* GLB: a head of 12 bytes, then parts of a length, a kind and bytes; the first is the JSON. */
static int find_json(struct sph_gltf *g, const struct sph_text *t, const char **json, size_t *size,
                     struct sph_error *err) {
    enum { HEAD = 12, PART = 8, JSON = 0x4e4f534a, BIN = 0x004e4942 };
    size_t all = (size_t)(t->end - t->bytes);
    *json = t->bytes, *size = all;
    if (all < 4 || memcmp(t->bytes, "glTF", 4) != 0) return 0;
    if (all < HEAD + PART || word_at(t->bytes + 8) > all)
        return sph_fail(err, "%s: the file ends early: %zu bytes", g->path, all);
    if (word_at(t->bytes + 4) != 2)
        return sph_fail(err, "%s: version %u of binary glTF, not 2", g->path,
                        word_at(t->bytes + 4));
    *size = word_at(t->bytes + HEAD);
    if (word_at(t->bytes + HEAD + 4) != JSON || *size > all - HEAD - PART)
        return sph_fail(err, "%s: its first part is no JSON of %zu bytes", g->path, *size);
    *json = t->bytes + HEAD + PART;
    size_t at = HEAD + PART + *size;
    if (all - at < PART) return 0;
    if (word_at(t->bytes + at) > all - at - PART)
        return sph_fail(err, "%s: the file ends within its binary part", g->path);
    if (word_at(t->bytes + at + 4) == BIN) g->bin = at + PART, g->bin_size = word_at(t->bytes + at);
    return 0;
}

int sph_gltf_open(struct sph_gltf *g, const char *path, struct sph_error *err) {
    struct sph_text t;
    const char *json;
    size_t size;
    json_error_t why;
    *g = (struct sph_gltf){.path = path};
    if (sph_text_open(&t, path, err)) return -1;
    int bad = find_json(g, &t, &json, &size, err);
    if (!bad) g->root = json_loadb(json, size, JSON_REJECT_DUPLICATES, &why);
    if (!bad && !g->root) bad = sph_fail(err, "%s:%d: %.200s", path, why.line, why.text);
    sph_text_close(&t);
    const char *version =
        json_string_value(json_object_get(json_object_get(g->root, "asset"), "version"));
    if (!bad && (!version || strncmp(version, "2.", 2) != 0))
        bad = sph_fail(err, "%s: glTF %.20s, not of version 2", path, version ? version : "?");
    if (bad) sph_gltf_close(g);
    return bad ? -1 : 0;
}

void sph_gltf_close(struct sph_gltf *g) {
    json_decref(g->root);
    g->root = NULL;
}

/* ---- what it names ---- */

static const json_t *list(const struct sph_gltf *g, const char *name) {
    return json_object_get(g->root, name);
}

static int note(const struct sph_gltf *g, struct sph_scene *scene, enum sph_read kind, uint64_t n,
                struct sph_error *err) {
    return sph_ledger_add(&scene->ledger, kind, n, g->path, 0, 0, err);
}

/* Extensions that are used here or whose absence changes nothing that is drawn. */
static int is_known(const char *name) {
    static const char *const known[] = {"KHR_lights_punctual", "KHR_materials_transmission",
                                        "KHR_materials_ior", "KHR_texture_transform",
                                        "KHR_materials_volume"};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (!strcmp(name, known[i])) return 1;
    return 0;
}

static int check_extensions(const struct sph_gltf *g, struct sph_scene *scene,
                            struct sph_error *err) {
    size_t i;
    json_t *v;
    json_array_foreach(list(g, "extensionsRequired"), i, v) {
        const char *name = json_string_value(v);
        if (name && !is_known(name))
            return sph_fail(err, "%s: needs the extension %.80s, which is not read", g->path, name);
    }
    json_array_foreach(list(g, "extensionsUsed"), i, v) {
        const char *name = json_string_value(v);
        if (note(g, scene, name && is_known(name) ? SPH_READ_WORD : SPH_READ_EXTENSION, 1, err))
            return -1;
    }
    return 0;
}

static int nibble(char c) {
    static const char digits[] = "0123456789abcdef";
    const char *at = c ? strchr(digits, tolower((unsigned char)c)) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* Text of a URI, with %20 and the like as bytes. */
static void decode(const char *uri, char *name, size_t size) {
    size_t n = 0;
    for (; *uri && n + 1 < size; uri++) {
        int high = uri[0] == '%' ? nibble(uri[1]) : -1, low = high < 0 ? -1 : nibble(uri[2]);
        name[n++] = (char)(low < 0 ? *uri : high << 4 | low);
        if (low >= 0) uri += 2;
    }
    name[n] = 0;
}

/* The file that an entry names: its path, empty if it names none. NULL, or what is wrong with it.
 */
static const char *file_of(const struct sph_gltf *g, const struct sph_scene *scene,
                           const json_t *entry, char *path, size_t size) {
    char name[512];
    *path = 0;
    const char *uri = json_string_value(json_object_get(entry, "uri"));
    if (!uri || !strncmp(uri, "data:", 5)) return NULL;
    decode(uri, name, sizeof name);
    return sph_mesh_beside(scene, g->path, name, path, size);
}

static int check_files(const struct sph_gltf *g, int skip, struct sph_scene *scene,
                       struct sph_error *err) {
    static const char *const lists[] = {"buffers", "images"};
    for (int k = 0; k < 2; k++) {
        size_t i;
        json_t *v;
        json_array_foreach(list(g, lists[k]), i, v) {
            char path[512];
            const char *wrong = file_of(g, scene, v, path, sizeof path);
            if (!wrong) continue;
            if (!k || !skip)
                return sph_fail(err, "%s: %s %zu: %.200s %s", g->path, k ? "image" : "buffer", i,
                                json_string_value(json_object_get(v, "uri")), wrong);
            if (note(g, scene, SPH_READ_MISSING, 1, err)) return -1;
        }
    }
    return 0;
}

/* Names, how they end, in the order of the ledger. */
static const struct {
    const char *name;
    enum sph_read kind;
} lists[] = {{"nodes", SPH_READ_NODE},
             {"materials", SPH_READ_MATERIAL},
             {"accessors", SPH_READ_CORNER},
             {"animations", SPH_READ_ANIMATION},
             {"skins", SPH_READ_ANIMATION}};

int sph_gltf_check(const struct sph_gltf *g, int skip, struct sph_scene *scene,
                   struct sph_error *err) {
    size_t i, k;
    json_t *mesh, *primitive;
    if (check_extensions(g, scene, err) || check_files(g, skip, scene, err)) return -1;
    for (i = 0; i < sizeof lists / sizeof *lists; i++)
        if (note(g, scene, lists[i].kind, json_array_size(list(g, lists[i].name)), err)) return -1;
    json_array_foreach(list(g, "meshes"), i, mesh) {
        json_array_foreach(json_object_get(mesh, "primitives"), k, primitive) {
            if (note(g, scene, SPH_READ_ANIMATION,
                     json_array_size(json_object_get(primitive, "targets")) > 0, err))
                return -1;
        }
    }
    return 0;
}

/* ---- materials ---- */

static double number(const json_t *of, const char *name, double otherwise) {
    const json_t *v = json_object_get(of, name);
    return json_is_number(v) ? json_number_value(v) : otherwise;
}

/* An extension of an object. */
static const json_t *extension(const json_t *of, const char *name) {
    return json_object_get(json_object_get(of, "extensions"), name);
}

/* A number of an entry that counts from 0; the entry of that list, NULL: none. */
static const json_t *entry(const struct sph_gltf *g, const char *of, const json_t *index) {
    json_int_t i = json_is_integer(index) ? json_integer_value(index) : -1;
    return i < 0 ? NULL : json_array_get(list(g, of), (size_t)i);
}

/* How an image lies on a surface: KHR_texture_transform. */
static void place(const json_t *texture, struct sph_look *look) {
    const json_t *t = extension(texture, "KHR_texture_transform");
    const json_t *scale = json_object_get(t, "scale"), *offset = json_object_get(t, "offset");
    double s[2] = {1, 1}, o[2] = {0, 0}, turn = number(t, "rotation", 0);
    for (size_t i = 0; i < 2; i++) {
        if (json_is_array(scale)) s[i] = json_number_value(json_array_get(scale, i));
        if (json_is_array(offset)) o[i] = json_number_value(json_array_get(offset, i));
    }
    const double m[2][3] = {{cos(turn) * s[0], sin(turn) * s[1], o[0]},
                            {-sin(turn) * s[0], cos(turn) * s[1], o[1]}};
    memcpy(look->place, m, sizeof m);
    look->coords = (int)number(t, "texCoord", number(texture, "texCoord", 0));
}

/* The image of a texture: a file, or a part of a GLB file, "file.glb#first+bytes". */
static int take_image(const struct sph_gltf *g, const json_t *texture, struct sph_look *look,
                      struct sph_scene *scene, struct sph_error *err) {
    enum { REPEATS = 10497 };
    const json_t *t = entry(g, "textures", json_object_get(texture, "index"));
    const json_t *image = entry(g, "images", json_object_get(t, "source"));
    const json_t *sampler = entry(g, "samplers", json_object_get(t, "sampler"));
    const char *wrong = image ? file_of(g, scene, image, look->image, sizeof look->image) : NULL;
    if (wrong) look->image[0] = 0; /* it was noted, or refused */
    if (!image || wrong) return 0;
    place(texture, look);
    if ((number(sampler, "wrapS", REPEATS) != REPEATS ||
         number(sampler, "wrapT", REPEATS) != REPEATS) &&
        note(g, scene, SPH_READ_WRAP, 1, err))
        return -1;
    if (look->image[0]) return note(g, scene, SPH_READ_PART, 1, err);
    const json_t *view = entry(g, "bufferViews", json_object_get(image, "bufferView"));
    const json_t *buffer = entry(g, "buffers", json_object_get(view, "buffer"));
    double at = number(view, "byteOffset", 0), n = number(view, "byteLength", 0);
    if (!buffer || json_object_get(buffer, "uri") || !(at >= 0 && n > 0) ||
        at + n > (double)g->bin_size)
        return note(g, scene, SPH_READ_IMAGE_INSIDE, 1, err);
    int size =
        snprintf(look->image, sizeof look->image, "%s#%.0f+%.0f", g->path, (double)g->bin + at, n);
    if (size >= (int)sizeof look->image)
        return sph_fail(err, "%s: the path of its image is too long", g->path);
    return note(g, scene, SPH_READ_PART, 1, err);
}

/* Parts of a material that nothing corresponds to. */
static int note_others(const struct sph_gltf *g, const json_t *m, const json_t *pbr,
                       struct sph_scene *scene, struct sph_error *err) {
    uint64_t n = (json_object_get(m, "normalTexture") != NULL) +
                 (uint64_t)(json_object_get(m, "occlusionTexture") != NULL) +
                 (uint64_t)(json_object_get(m, "emissiveTexture") != NULL) +
                 (uint64_t)(json_object_get(m, "emissiveFactor") != NULL) +
                 (uint64_t)(json_object_get(pbr, "metallicRoughnessTexture") != NULL);
    return note(g, scene, SPH_READ_PART_OTHER, n, err);
}

static double limited(double v) {
    return v > 0 ? fmin(v, 1) : 0;
}

/* The machine has one number each for what mirrors and what passes. A metal mirrors its mean colour
 * as far as it is smooth and is matt as far as it is rough; glass mirrors as Fresnel says of light
 * that comes straight. Highlight: Blinn's exponent 2 / roughness^4 - 2. */
int sph_gltf_look(const struct sph_gltf *g, unsigned index, struct sph_look *look,
                  struct sph_scene *scene, struct sph_error *err) {
    const json_t *m = json_array_get(list(g, "materials"), index);
    const json_t *pbr = json_object_get(m, "pbrMetallicRoughness");
    const json_t *base = json_object_get(pbr, "baseColorFactor");
    const json_t *glass = extension(m, "KHR_materials_transmission");
    const json_t *bends = extension(m, "KHR_materials_ior");
    const char *mode = json_string_value(json_object_get(m, "alphaMode"));
    double c[4] = {1, 1, 1, 1};
    for (size_t i = 0; i < 4 && json_is_array(base); i++)
        c[i] = limited(json_number_value(json_array_get(base, i)));
    const double metal = limited(number(pbr, "metallicFactor", 1));
    const double rough = limited(number(pbr, "roughnessFactor", 1));
    const double ior = number(bends, "ior", DIELECTRIC), mean = (c[0] + c[1] + c[2]) / 3;
    const double top = fmax(c[0], fmax(c[1], c[2])), face = (ior - 1) / (ior + 1);
    double passes = limited(number(glass, "transmissionFactor", 0)) * (1 - metal);
    const double mirrors = metal * (1 - rough);
    for (int i = 0; i < 3; i++)
        look->rgb[i] = top > 0 ? c[i] / top : 0;
    look->kr = mirrors * mean + (passes > 0 ? passes * face * face : 0);
    look->kd = top * (1 - mirrors) * (1 - passes);
    look->ks = rough < 1 ? (1 - metal) * face * face + metal * mean : 0;
    look->shine = rough < 1 ? 2 / pow(rough, 4) - 2 : 0;
    if (look->ks > 0) look->shine = fmin(fmax(look->shine, SPH_SHINE_MIN), SPH_SHINE_MAX);
    look->ior = 1; /* thin, as transmission without a volume or an index of its own is */
    if (bends || extension(m, "KHR_materials_volume")) look->ior = ior;
    if (mode && !strcmp(mode, "BLEND") && c[3] < 1) {
        look->kd *= c[3], look->ks *= c[3], look->kr *= c[3];
        passes = 1 - c[3] * (1 - passes);
    }
    look->trans = passes;
    if (mode && !strcmp(mode, "MASK") && note(g, scene, SPH_READ_CUTOUT, 1, err)) return -1;
    if ((mirrors > 0 || passes > 0) && rough > 0 && note(g, scene, SPH_READ_ROUGH, 1, err))
        return -1;
    return note_others(g, m, pbr, scene, err) ||
                   take_image(g, json_object_get(pbr, "baseColorTexture"), look, scene, err)
               ? -1
               : 0;
}
