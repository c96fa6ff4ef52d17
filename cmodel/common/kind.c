/* kind.c - see kind.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "common/kind.h"

#include <stddef.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "common/packed.h"

enum { HEAD = 4096 }; /* bytes that are looked at */

struct look {
    enum sph_file_kind kind;
    const char *text;
};

/* First bytes that only one kind has. */
static const struct {
    const char *bytes;
    size_t n, at;
    struct look look;
} starts[] = {
    {"SPHAERA", 7, 0, {SPH_FILE_MACHINE, "a machine file"}},
    {"\x89PNG", 4, 0, {SPH_FILE_IMAGE, "a PNG image"}},
    {"\xff\xd8\xff", 3, 0, {SPH_FILE_IMAGE, "a JPEG image"}},
    {"GIF8", 4, 0, {SPH_FILE_IMAGE, "a GIF image"}},
    {"WEBP", 4, 8, {SPH_FILE_IMAGE, "a WebP image"}},
    {"v/1\x01", 4, 0, {SPH_FILE_IMAGE, "an OpenEXR image"}},
    {"II*\0", 4, 0, {SPH_FILE_IMAGE, "a TIFF image"}},
    {"MM\0*", 4, 0, {SPH_FILE_IMAGE, "a TIFF image"}},
    {"#?RADIANCE", 10, 0, {SPH_FILE_IMAGE, "a Radiance image"}},
    {"BM", 2, 0, {SPH_FILE_IMAGE, "a BMP image"}},
    {"P5", 2, 0, {SPH_FILE_IMAGE, "a PGM image"}},
    {"P6", 2, 0, {SPH_FILE_IMAGE, "a PPM image"}},
    {"glTF", 4, 0, {SPH_FILE_GLB, "a binary glTF scene"}},
    {"ply", 3, 0, {SPH_FILE_PLY, "a PLY mesh"}},
    {"PK\x03\x04", 4, 0, {SPH_FILE_OTHER, "a ZIP archive: unpack it first"}},
    {"BLENDER", 7, 0, {SPH_FILE_OTHER, "a Blender file: export it as glTF"}},
    {"%PDF", 4, 0, {SPH_FILE_OTHER, "a PDF document"}},
    {"Kaydara FBX", 11, 0, {SPH_FILE_OTHER, "an FBX scene: export it as glTF"}},
    {"PXR-USDC", 8, 0, {SPH_FILE_OTHER, "a USD scene: export it as glTF"}},
    {"#usda", 5, 0, {SPH_FILE_OTHER, "a USD scene: export it as glTF"}},
    {"#VRML", 5, 0, {SPH_FILE_OTHER, "a VRML scene: export it as glTF"}},
    {"ISO-10303-21", 12, 0, {SPH_FILE_OTHER, "a STEP model: export it as STL"}},
    {"OFF", 3, 0, {SPH_FILE_OTHER, "an OFF mesh: convert it to PLY"}},
    {"# vtk DataFile", 14, 0, {SPH_FILE_OTHER, "a VTK data set: write it as PLY"}},
    {"# .PCD", 6, 0, {SPH_FILE_OTHER, "a PCD point cloud: convert it to PLY"}},
    {"LASF", 4, 0, {SPH_FILE_OTHER, "a LAS point cloud: convert it to PLY"}},
    {"ASTM-E57", 8, 0, {SPH_FILE_OTHER, "an E57 point cloud: convert it to PLY"}},
    {"\x89HDF", 4, 0, {SPH_FILE_OTHER, "an HDF5 file"}},
    {"CDF", 3, 0, {SPH_FILE_OTHER, "a NetCDF file"}},
    {"@<TRIPOS>", 9, 0, {SPH_FILE_OTHER, "a MOL2 molecule: convert it to PDB"}},
    {"\x7f"
     "ELF",
     4,
     0,
     {SPH_FILE_OTHER, "a program"}},
};

/* Endings of names, where the content says nothing else. */
static const struct {
    const char *ending;
    struct look look;
} endings[] = {
    {"sph", {SPH_FILE_MACHINE, "a machine file"}},
    {"nff", {SPH_FILE_NFF, "an NFF scene"}},
    {"aff", {SPH_FILE_AFF, "an AFF scene"}},
    {"pdb", {SPH_FILE_PDB, "a PDB molecule"}},
    {"ent", {SPH_FILE_PDB, "a PDB molecule"}},
    {"cif", {SPH_FILE_CIF, "a CIF molecule"}},
    {"mmcif", {SPH_FILE_CIF, "a CIF molecule"}},
    {"xyz", {SPH_FILE_XYZ, "a list of atoms (XYZ)"}},
    {"csv", {SPH_FILE_CSV, "a table of points"}},
    {"tsv", {SPH_FILE_CSV, "a table of points"}},
    {"obj", {SPH_FILE_OBJ, "a Wavefront OBJ mesh"}},
    {"stl", {SPH_FILE_STL, "an STL mesh"}},
    {"ply", {SPH_FILE_PLY, "a PLY mesh"}},
    {"gltf", {SPH_FILE_GLTF, "a glTF scene"}},
    {"glb", {SPH_FILE_GLB, "a binary glTF scene"}},
    {"mtl", {SPH_FILE_OTHER, "a material library of OBJ meshes: give the .obj file"}},
    {"pov", {SPH_FILE_OTHER, "a POV-Ray scene"}},
    {"tga", {SPH_FILE_IMAGE, "a Targa image"}},
};

/* What stands behind these words at the start of the next line, from *at on, that has them, which
 * *at then is behind; NULL: none has. */
static const char *behind(const char **at, const char *start) {
    size_t n = strlen(start);
    while (*at) {
        const char *line = *at + strspn(*at, "\r\n");
        *at = strpbrk(line, "\r\n");
        if (!strncmp(line, start, n)) return line + n;
    }
    return NULL;
}

/* Whether a line of the text starts with these words. */
static int has_line(const char *text, const char *start) {
    return behind(&text, start) != NULL;
}

/* Whether a line of the text is this word and a number. */
static int has_number(const char *text, const char *word) {
    for (const char *rest; (rest = behind(&text, word)) != NULL;) {
        size_t blanks = strspn(rest, " \t");
        if (blanks && rest[blanks] && strchr("+-.0123456789", rest[blanks])) return 1;
    }
    return 0;
}

/* What a text says by its words; the kind that is asked for last is the least certain. */
static struct look by_words(const char *text) {
    int vertex = has_number(text, "v");
    if (!vertex && (has_line(text, "v\n") || has_line(text, "v\r") || has_line(text, "v ")))
        return (struct look){SPH_FILE_NFF, "an NFF scene"};
    if (has_line(text, "data_") && strstr(text, "\n_"))
        return (struct look){SPH_FILE_CIF, "a CIF molecule"};
    if (has_line(text, "ATOM  ") || has_line(text, "HETATM") || has_line(text, "HEADER    "))
        return (struct look){SPH_FILE_PDB, "a PDB molecule"};
    if (has_line(text, "newmtl "))
        return (struct look){SPH_FILE_OTHER,
                             "a material library of OBJ meshes: give the .obj file"};
    if (vertex || has_line(text, "mtllib "))
        return (struct look){SPH_FILE_OBJ, "a Wavefront OBJ mesh"};
    if (has_line(text, "solid") && strstr(text, "facet"))
        return (struct look){SPH_FILE_STL, "an STL mesh"};
    if (text[strspn(text, " \t\r\n")] == '{' &&
        (strstr(text, "\"asset\"") || strstr(text, "\"accessors\"") || strstr(text, "\"nodes\"")))
        return (struct look){SPH_FILE_GLTF, "a glTF scene"};
    if (strstr(text, "<COLLADA"))
        return (struct look){SPH_FILE_OTHER, "a COLLADA scene: export it as glTF"};
    if (!strncmp(text, "<?xml", 5)) return (struct look){SPH_FILE_OTHER, "an XML file"};
    return (struct look){SPH_FILE_NFF, NULL};
}

/* Whether a binary file is as long as an STL mesh of as many triangles as it says. */
static int is_stl(const char *path, const char *head, size_t n) {
    enum { TITLE = 80, EACH = 50 };
    struct stat about;
    long long triangles = 0;
    if (n < TITLE + 4 || stat(path, &about)) return 0;
    for (int i = 3; i >= 0; i--)
        triangles = triangles << 8 | (unsigned char)head[TITLE + i];
    return about.st_size == TITLE + 4 + EACH * triangles;
}

/* What stands behind the last point of a name, of n characters; NULL: there is none. */
static const char *ending_of(const char *name, size_t n) {
    while (n > 0 && name[n - 1] != '.' && name[n - 1] != '/')
        n--;
    return n > 0 && name[n - 1] == '.' ? name + n : NULL;
}

/* What the file at path is by its first n bytes, and by its ending, of so many characters. */
static struct look look_at(const char *path, const char *head, size_t n, const char *ending,
                           size_t length) {
    struct look look = {SPH_FILE_NFF, NULL};
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (n >= starts[i].at + starts[i].n &&
            !memcmp(head + starts[i].at, starts[i].bytes, starts[i].n))
            return starts[i].look;
    int binary = memchr(head, 0, n) != NULL;
    if (binary && is_stl(path, head, n)) look = (struct look){SPH_FILE_STL, "an STL mesh"};
    if (!binary) look = by_words(head);
    for (size_t i = 0; ending && !look.text && i < sizeof endings / sizeof *endings; i++)
        if (length == strlen(endings[i].ending) && !strncasecmp(ending, endings[i].ending, length))
            look = endings[i].look;
    /* NFF and AFF share their words */
    if (ending && look.kind == SPH_FILE_NFF && length == 3 && !strncasecmp(ending, "aff", 3))
        look = (struct look){SPH_FILE_AFF, "an AFF scene"};
    if (!look.text) look.text = binary ? "binary, of no kind that is known here" : "a text";
    return look;
}

enum sph_file_kind sph_file_kind(const char *path, const char **looks) {
    char head[HEAD + 1] = "";
    const char *none, *end = path + strlen(path);
    FILE *file = sph_input_text(path, NULL);
    size_t n = file ? fread(head, 1, HEAD, file) : 0;
    int packed = file && sph_input_packed(path);
    if (file) fclose(file);
    if (packed && end - path > 3 && !strcasecmp(end - 3, ".gz")) end -= 3;
    const char *ending = ending_of(path, (size_t)(end - path));
    struct look look = look_at(path, head, n, ending, ending ? (size_t)(end - ending) : 0);
    int text = look.kind == SPH_FILE_NFF || look.kind == SPH_FILE_AFF ||
               look.kind == SPH_FILE_PDB || look.kind == SPH_FILE_CIF ||
               look.kind == SPH_FILE_XYZ || look.kind == SPH_FILE_CSV;
    if (packed && !text)
        look = (struct look){SPH_FILE_OTHER, "a file packed by gzip: unpack it first"};
    if (!looks) looks = &none;
    *looks = look.text;
    return look.kind;
}
