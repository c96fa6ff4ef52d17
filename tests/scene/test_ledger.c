/* test_ledger.c - every record of a file ends in the ledger: used, used otherwise, or left out
 * SPDX-License-Identifier: Apache-2.0
 *
 * One small file for each kind, which is found with its line, and which `strict` refuses with file
 * and line if it is not used as it stands.
 */
#include "scene_files.h"

#include "builder/build.h"
#include "builder/warn.h"
#include "scene/import.h"
#include "common/module.h"
#include "texture/lookup.h"
#include "validate/describe.h"

#define SPH "s 0 0 0 1\n"
#define MATT "f 1 0 0 1 0 0 0 1\n"
#define GLASS "f 1 1 1 .1 .1 50 .7 1.5\n"
#define ATOM(serial, name, place, residue, x, element)                                             \
    "ATOM  " serial " " name place residue " A   1    " x                                          \
    "   0.000   0.000  1.00  0.00          " element "\n"
#define CA ATOM("    1", " CA ", " ", "ALA", "   0.000", " C")
#define LOOP                                                                                       \
    "data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"                  \
    "_atom_site.type_symbol\n_atom_site.pdbx_PDB_model_num\n"

#define CONN                                                                                       \
    "data_x\nloop_\n_struct_conn.conn_type_id\n_struct_conn.ptnr1_label_atom_id\n"                 \
    "_struct_conn.ptnr2_label_atom_id\n_struct_conn.ptnr1_symmetry\n_struct_conn.ptnr2_symmetry\n"
#define ATOMS                                                                                      \
    "loop_\n_atom_site.group_PDB\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"    \
    "_atom_site.type_symbol\n"

#define CORNERS "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
#define OBJ CORNERS "f 1 2 3\n"
#define MTL "mtllib m.mtl\nusemtl m\n" OBJ
#define PLY(more, rows)                                                                            \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"                \
    "property float z\n" more "element face 1\nproperty list uchar int vertex_indices\n"           \
    "end_header\n" rows "3 0 1 2\n"
/* A triangle; what its node and its material have besides, and the file. */
#define GLTF(node, material, more)                                                                 \
    "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],"                               \
    "\"nodes\":[{\"mesh\":0" node "}],\"materials\":[{" material "}],"                             \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":0}]}],"            \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"     \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}]," more                                     \
    "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"              \
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}"
#define IMAGE(image, sampler)                                                                      \
    GLTF("", "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}",                      \
         "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{" sampler                     \
         "}],\"images\":[{\"uri\":\"" image "\"}],")
#define LIGHTS(intensity)                                                                          \
    GLTF(",\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}", "",                            \
         "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"type\":\"point\","               \
         "\"intensity\":" intensity "}]}},")

/* Files that stand beside. */
static const char *const beside[][2] = {
    {"m.mtl", "newmtl m\nKd 1 2 0\nKs .1 .2 .3\nNs 9\nKe 1 1 1\n"},
    {"i.png", "no image, which nobody reads here"},
};
enum { BESIDE = sizeof beside / sizeof *beside };

enum { READ, STICKS, BUILD, IMAGES, FILE_OF_MACHINE, MESH };

static const struct row {
    enum sph_read kind;
    const char *name; /* of the file */
    const char *text;
    uint32_t line;
    int how; /* who notes it: the reader, import of sticks, build, readers of images or machines,
                the reader by assimp */
} rows[] = {
    {SPH_READ_CAMERA, "a.nff", CAM, 1, READ},
    {SPH_READ_LIGHT, "a.nff", CAM LIGHT, 8, READ},
    {SPH_READ_COLOUR, "a.nff", CAM "b 0 0 0\n", 8, READ},
    {SPH_READ_MATERIAL, "a.nff", CAM MATT, 8, READ},
    {SPH_READ_BLEND, "a.nff", CAM "shading blend\n" GLASS, 9, READ},
    {SPH_READ_WORD, "a.nff", CAM "shading blend\n", 8, READ},
    {SPH_READ_HIDDEN, "a.aff", CAM "k x { visibility 1 0 0 }\n" MATT "x x {\n" SPH "}\na 0 1 2\n",
     11, READ},
    {SPH_READ_DETAIL, "a.aff", CAM "i 3 other.nff\n", 8, READ},
    {SPH_READ_SPHERE, "a.nff", CAM MATT SPH, 9, READ},
    {SPH_READ_POLYGON, "a.nff", CAM MATT "p 3 0 0 0 1 0 0 0 1 0\n", 9, READ},
    {SPH_READ_TRIANGLE, "a.nff", CAM MATT "tt none 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0\n", 9, READ},
    {SPH_READ_CONE, "a.nff", CAM MATT "c 0 0 0 1 0 0 1 1\n", 9, READ},
    {SPH_READ_PLANE, "a.nff", CAM MATT "plane 0 0 0 0 1 0\n", 9, READ},
    {SPH_READ_MESH, "a.aff", CAM MATT "m vertices 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 2\n", 9,
     READ},
    {SPH_READ_ATOM, "a.pdb", "REMARK\n" CA, 2, READ},
    {SPH_READ_ATOM, "a.cif", LOOP "0 0 0 C 1\n# end\n", 8, READ},
    {SPH_READ_ATOM, "a.xyz", "2\nwords\nC 0 0 0\nO 1 0 0\n", 3, READ},
    {SPH_READ_SPHERE, "a.csv", "x,y,z,r\n1,2,3,4\n", 2, READ},
    {SPH_READ_NO_ATOM, "a.pdb", "REMARK\n" CA, 1, READ},
    {SPH_READ_IMAGE, "a.nff", CAM MATT "texture a.png 1 1 linear\n" SPH, 9, IMAGES},
    {SPH_READ_SHINE_NONE, "a.nff", CAM "f 1 1 1 .5 .5 0 0 1\n", 8, READ},
    {SPH_READ_SHINE_LIMITED, "a.nff", CAM "f 1 1 1 .5 .5 999 0 1\n", 8, READ},
    {SPH_READ_INDEX_LIMITED, "a.nff", CAM "f 1 1 1 .5 .5 9 .5 5\n", 8, READ},
    {SPH_READ_FM_MEAN, "a.nff", CAM "fm 0 0 0 1 1 1 0 0 0 1 0 1\n", 8, READ},
    {SPH_READ_LIGHT_LIMITED, "a.nff", CAM "l 0 0 0 3 1 1\n", 8, BUILD},
    {SPH_READ_BENT, "a.nff", CAM MATT "p 4 0 0 0 1 0 0 1 1 .1 0 1 0\n", 9, READ},
    {SPH_READ_GLASS_MEETS, "a.nff", CAM GLASS SPH "s 1 0 0 1\n", 10, READ},
    {SPH_READ_SRGB, "a.nff", CAM MATT "texture a.png 1 1\n" SPH, 9, IMAGES},
    {SPH_READ_ALTERNATE, "a.pdb",
     ATOM("    1", " CA ", "B", "ALA", "   0.000", " C") /* no A, and of two the first */
     ATOM("    2", " CA ", "C", "ALA", "   1.000", " C"),
     1, READ},
    {SPH_READ_OTHER_PLACE, "a.pdb",
     ATOM("    1", " CA ", "B", "ALA", "   0.000", " C")
         ATOM("    2", " CA ", "C", "ALA", "   1.000", " C"),
     2, READ},
    {SPH_READ_ELEMENT, "a.pdb", CA ATOM("    2", " CB ", " ", "ALA", "   5.000", "  "), 2, READ},
    {SPH_READ_SHIFTED, "a.pdb", ATOM("100000", " CA ", " ", "ALA", "   0.000", " C"), 1, READ},
    {SPH_READ_NO_AREA, "a.nff", CAM MATT "p 3 0 0 0 1 1 1 2 2 2\n", 9, READ},
    {SPH_READ_NO_AREA_GRID, "a.nff", CAM MATT "p 3 0 0 0 1 0 0 0 1 0\np 3 0 0 0 1e-9 0 0 0 1 0\n",
     10, BUILD},
    {SPH_READ_TRIANGLE_TWICE, "a.nff", CAM MATT "p 3 0 0 0 1 0 0 0 1 0\np 3 0 0 0 1 0 0 0 1 0\n",
     10, BUILD},
    {SPH_READ_TRIANGLE_GRID, "a.nff", CAM MATT "p 3 0 0 0 1 0 0 0 1 0\np 3 0 0 0 1 0 0 0 1 1e-9\n",
     10, BUILD},
    {SPH_READ_SPHERE_TWICE, "a.nff", CAM MATT SPH SPH, 10, READ},
    {SPH_READ_SPHERE_GRID, "a.nff", CAM MATT SPH "s 0 0 1e-9 1\n", 10, BUILD},
    {SPH_READ_SPHERE_SMALL, "a.nff", CAM MATT SPH "s 2 0 0 1e-9\n", 10, BUILD},
    {SPH_READ_NO_SIZE, "a.aff", CAM MATT "xs 0 0 0 0 1 0 0 0 0 0 {\n" SPH "}\n", 10, READ},
    {SPH_READ_UNSUPPORTED, "a.nff", CAM MATT "pb 3 1 2\n", 9, READ},
    {SPH_READ_WATER, "a.pdb", CA ATOM("    2", " OH2", " ", "TIP", "   5.000", " O"), 2, READ},
    {SPH_READ_SAME_PLACE, "a.pdb", CA ATOM("    2", " CB ", " ", "ALA", "   0.000", " C"), 2, READ},
    {SPH_READ_NO_ELEMENT, "a.pdb", CA ATOM("    2", " EP ", " ", "LIG", "   5.000", "  "), 2, READ},
    {SPH_READ_UNKNOWN, "a.pdb", CA ATOM("    2", " ?? ", " ", "LIG", "   5.000", "  "), 2, READ},
    {SPH_READ_MODEL, "a.pdb", CA "END   \n" CA, 3, READ},
    {SPH_READ_MODEL, "a.cif", LOOP "0 0 0 C 1\n0 0 9 C 2\n", 9, READ},
    {SPH_READ_MODEL, "a.xyz", "1\nfirst\nC 0 0 0\n1\nsecond\nC 0 0 0\n", 4, READ},
    {SPH_READ_BONDS, "a.pdb", CA "CONECT    1    2\n", 2, READ},
    {SPH_READ_BONDS, "a.cif", CONN "covale A B . .\n" ATOMS "ATOM 0 0 0 C\n", 8, READ},
    {SPH_READ_BOND_GIVEN, "a.pdb",
     CA ATOM("    2", " NA ", " ", "ALA", "   9.000", "Na") "CONECT    1    2\n", 3, STICKS},
    {SPH_READ_BOND_TOLD, "a.pdb", CA ATOM("    2", " CB ", " ", "ALA", "   1.500", " C"), 1,
     STICKS},
    {SPH_READ_BOND_NONE, "a.pdb", CA "CONECT    1    2\n", 2, STICKS},
    {SPH_READ_BOND_WEAK, "a.pdb", CA "CONECT    1                             2\n", 2, READ},
    {SPH_READ_BOND_WEAK, "a.cif", CONN "hydrog A B . .\n" ATOMS "ATOM 0 0 0 C\n", 8, READ},
    {SPH_READ_BOND_FAR, "a.cif", CONN "covale A B 1_555 2_555\n" ATOMS "ATOM 0 0 0 C\n", 8, READ},
    {SPH_READ_ROW_LONG, "a.cif", "data_x\n" ATOMS "ATOM 0 0 0 C 1 2\nATOM 9 9 9 C 1 2\n", 8, READ},
    {SPH_READ_NO_ATOM, "a.cif", "data_x\n_cell.length_a 9\n" ATOMS "ATOM 0 0 0 C\n", 2, READ},
    {SPH_READ_NO_ATOM, "a.xyz", "1\nwords\nC 0 0 0\n", 1, READ},
    {SPH_READ_WORD, "a.csv", "x,y,z\n1,2,3\n", 1, READ},
    {SPH_READ_MACHINE, "a.nff", CAM MATT SPH, 0, FILE_OF_MACHINE},
    {SPH_READ_CORNER, "a.obj", OBJ, 1, MESH},
    {SPH_READ_CORNER, "a.ply", PLY("", "0 0 0\n1 0 0\n0 1 0\n"), 10, MESH},
    {SPH_READ_TRIANGLE, "a.ply", PLY("", "0 0 0\n1 0 0\n0 1 0\n"), 13, MESH},
    {SPH_READ_TRIANGLE, "a.stl",
     "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
     "endfacet\nendsolid\n",
     2, MESH},
    {SPH_READ_MATERIAL, "a.obj", MTL, 1, MESH},
    {SPH_READ_PART, "a.obj", MTL, 2, MESH},
    {SPH_READ_NODE, "a.gltf", GLTF("", "", ""), 0, MESH},
    {SPH_READ_FLAT, "a.obj", "s 1\n" OBJ, 1, MESH},
    {SPH_READ_CORNER_COLOURS, "a.ply",
     PLY("property uchar red\nproperty uchar green\nproperty uchar blue\n",
         "0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n"),
     16, MESH},
    {SPH_READ_PART_MEAN, "a.obj", MTL, 0, MESH},
    {SPH_READ_PART_LIMITED, "a.obj", MTL, 0, MESH},
    {SPH_READ_ROUGH, "a.gltf", GLTF("", "\"pbrMetallicRoughness\":{\"roughnessFactor\":0.5}", ""),
     0, MESH},
    {SPH_READ_CUTOUT, "a.gltf", GLTF("", "\"alphaMode\":\"MASK\"", ""), 0, MESH},
    {SPH_READ_WRAP, "a.gltf", IMAGE("i.png", "\"wrapS\":33071"), 0, MESH},
    {SPH_READ_LIGHT_PLAIN, "a.gltf", LIGHTS("5"), 0, MESH},
    {SPH_READ_LIGHT_OTHER, "a.gltf", LIGHTS("0"), 0, MESH},
    {SPH_READ_LINE, "a.obj", OBJ "l 1 2\n", 5, MESH},
    {SPH_READ_PROPERTY, "a.ply", PLY("property float radius\n", "0 0 0 1\n1 0 0 1\n0 1 0 1\n"), 7,
     MESH},
    {SPH_READ_PART_OTHER, "a.obj", MTL, 5, MESH},
    {SPH_READ_MISSING, "a.obj", "mtllib none.mtl\n" OBJ, 1, MESH},
    {SPH_READ_IMAGE_INSIDE, "a.gltf", IMAGE("data:image/png;base64,AAAA", ""), 0, MESH},
    {SPH_READ_CAMERA_OTHER, "a.gltf",
     GLTF(",\"camera\":0", "",
          "\"cameras\":[{\"type\":\"orthographic\",\"orthographic\":{\"xmag\":1,\"ymag\":1,"
          "\"zfar\":9,\"znear\":1}}],"),
     0, MESH},
    {SPH_READ_ANIMATION, "a.gltf", GLTF("", "", "\"skins\":[{\"joints\":[0]}],"), 0, MESH},
    {SPH_READ_EXTENSION, "a.gltf", GLTF("", "", "\"extensionsUsed\":[\"FOO_bar\"],"), 0, MESH},
};
enum { ROWS = sizeof rows / sizeof *rows };

/* The ledger of a file, and what is said of it under `strict`, if anything. */
static struct sph_ledger ledger_of(const struct row *row, int strict, struct sph_error *err) {
    static struct sph_build_report report;
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    const struct sph_read_options how = {.skip_unsupported = 1, .strict = strict};
    struct sph_scene scene;
    snprintf(file_name, sizeof file_name, "%s/%s", folder, row->name);
    put_file(row->text, strlen(row->text));
    const struct sph_import_options balls = {.strict = strict, .sticks = 1};
    int rc = row->how == STICKS
                 ? sph_import(file_name, sph_file_kind(file_name, NULL), &balls, &scene, err)
                 : sph_scene_read(file_name, &how, &scene, err);
    unlink(file_name);
    if (rc) return (struct sph_ledger){0};
    struct sph_ledger ledger = scene.ledger;
    if (row->how == IMAGES) {
        struct sph_mip mip = {.decoded = row->kind == SPH_READ_SRGB};
        sph_note_images(&scene, &mip, &ledger, err);
    }
    if (row->how == BUILD || row->how == FILE_OF_MACHINE) {
        struct sph_machine m;
        o.width = 16, o.height = 9, o.profile = SPH_REFERENCE;
        int built = !sph_build(&scene, &o, &m, &report, err);
        ledger = row->how == BUILD ? report.ledger : (struct sph_ledger){0};
        if (built && row->how == FILE_OF_MACHINE) sph_machine_note(&m, file_name, &ledger);
        if (built) sph_machine_free(&m);
    }
    sph_scene_free(&scene);
    return ledger;
}

static void test_rows(void **state) {
    (void)state;
    int found[SPH_READS] = {0};
    char why[400];
    int meshes = sph_module_load("mesh", why, sizeof why) != NULL;
    if (!meshes) printf("# skip meshes: built without assimp (make mesh-setup)\n");
    for (int i = 0; i < BESIDE; i++) {
        snprintf(file_name, sizeof file_name, "%s/%s", folder, beside[i][0]);
        put_file(beside[i][1], strlen(beside[i][1]));
    }
    for (int i = 0; i < ROWS; i++) {
        const struct row *r = &rows[i];
        if (r->how == MESH && !meshes) {
            found[r->kind] = 1;
            continue;
        }
        struct sph_error err = {""}, refused = {""};
        char start[200];
        struct sph_ledger ledger = ledger_of(r, 0, &err);
        if (err.text[0]) fail_msg("row %d (%s): %s", i, sph_read_name(r->kind), err.text);
        if (!ledger.row[r->kind].n || ledger.row[r->kind].line != r->line)
            fail_msg("row %d (%s): %llu times, line %u", i, sph_read_name(r->kind),
                     (unsigned long long)ledger.row[r->kind].n, ledger.row[r->kind].line);
        found[r->kind] = 1;
        if (sph_read_end(r->kind) == SPH_USED) continue;
        ledger_of(r, 1, &refused);
        snprintf(start, sizeof start, "%s/", folder);
        if (strncmp(refused.text, start, strlen(start)) != 0)
            fail_msg("row %d (%s): strict says \"%s\"", i, sph_read_name(r->kind), refused.text);
    }
    for (int i = 0; i < BESIDE; i++) {
        snprintf(file_name, sizeof file_name, "%s/%s", folder, beside[i][0]);
        unlink(file_name);
    }
    for (int kind = 0; kind < SPH_READS; kind++)
        if (!found[kind]) fail_msg("no file has a \"%s\"", sph_read_name((enum sph_read)kind));
}

/* Every record that a format has, behind what it needs before it: each is one more in the ledger
 * (two where it holds another record), as this kind. */
#define VIEW "v from 0 0 5 at 0 0 0 up 0 1 0 angle 30 hither 1 resolution 16 9\n"
#define MESH_HEAD "vertices 3 0 0 0 1 0 0 0 1 0 "
static const struct word {
    const char *name, *before, *record;
    enum sph_read kind;
} words[] = {
    {"a.nff", "", VIEW, SPH_READ_CAMERA},
    {"a.nff", VIEW, "b 0 0 0", SPH_READ_COLOUR},
    {"a.nff", VIEW, "ambient 0 0 0", SPH_READ_COLOUR},
    {"a.nff", VIEW, "l 1 1 1", SPH_READ_LIGHT},
    {"a.nff", VIEW, "l 1 1 1 .5 .5 .5", SPH_READ_LIGHT},
    {"a.nff", VIEW, "f 1 0 0 1 0 0 0 1", SPH_READ_MATERIAL},
    {"a.nff", VIEW, "fm 1 0 0 1 0 0 0 0 0 0 0 1", SPH_READ_MATERIAL},
    {"a.nff", VIEW, "shading sum", SPH_READ_WORD},
    {"a.nff", VIEW, "shadows clear", SPH_READ_WORD},
    {"a.nff", VIEW, "texture none", SPH_READ_WORD},
    {"a.nff", VIEW, "move 1 0 0", SPH_READ_WORD},
    {"a.nff", VIEW, "still", SPH_READ_WORD},
    {"a.nff", VIEW, "fly 1 0 0 9 0 0 0", SPH_READ_WORD},
    {"a.nff", VIEW MATT, "s 0 0 0 1", SPH_READ_SPHERE},
    {"a.nff", VIEW MATT, "p 3 0 0 0 1 0 0 0 1 0", SPH_READ_POLYGON},
    {"a.nff", VIEW MATT, "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1", SPH_READ_POLYGON},
    {"a.nff", VIEW MATT, "c 0 0 0 1 0 0 1 1", SPH_READ_CONE},
    {"a.nff", VIEW MATT, "plane 0 0 0 0 1 0", SPH_READ_PLANE},
    {"a.nff", VIEW MATT, "tt none 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0", SPH_READ_TRIANGLE},
    {"a.nff", VIEW MATT, "ttp none 0 0 0 0 0 1 0 0 1 0 0 0 0 1 0 0 0 1 0 0 0 1 0 0",
     SPH_READ_TRIANGLE},
    {"a.nff", VIEW MATT, "pb 3 1 2", SPH_READ_UNSUPPORTED},
    {"a.nff", VIEW MATT, "t 1 2", SPH_READ_UNSUPPORTED},
    {"a.nff", VIEW MATT, "tpp none 1 2", SPH_READ_UNSUPPORTED},
    {"a.aff", VIEW, "am 0 0 0", SPH_READ_COLOUR},
    {"a.aff", VIEW, "l 1 1 1", SPH_READ_LIGHT},
    {"a.aff", VIEW, "la x 1 1 1 .5 .5 .5", SPH_READ_LIGHT},
    {"a.aff", VIEW, "d 2", SPH_READ_WORD},
    {"a.aff", VIEW, "i 3 other.aff", SPH_READ_DETAIL},
    {"a.aff", VIEW, "a 0 1 2", SPH_READ_WORD},
    {"a.aff", VIEW, "k x { visibility 1 0 1 }", SPH_READ_WORD},
    {"a.aff", VIEW MATT, "x x { s 0 0 0 1 }", SPH_READ_WORD},
    {"a.aff", VIEW MATT, "xs 1 1 1 0 0 1 0 0 0 0 { s 0 0 0 1 }", SPH_READ_WORD},
    {"a.aff", VIEW MATT, "m " MESH_HEAD "triangles 1 0 1 2", SPH_READ_MESH},
    {"a.aff", VIEW MATT, "tpa 1 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1", SPH_READ_TRIANGLE},
    {"a.pdb", CA, "HEADER    TOXIN", SPH_READ_NO_ATOM},
    {"a.pdb", CA, "REMARK 350", SPH_READ_NO_ATOM},
    {"a.pdb", CA, "TER", SPH_READ_NO_ATOM},
    {"a.pdb", CA, "ANISOU    1  CA  ALA A   1      100    100    100      0      0      0",
     SPH_READ_NO_ATOM},
    {"a.pdb", CA, "CONECT    1", SPH_READ_BONDS},
    {"a.pdb", CA, "ATOM      2  N   ALA A   1       5.000   0.000   0.000", SPH_READ_ELEMENT},
    {"a.pdb", CA, "HETATM    2  N   LIG A   1       5.000   0.000   0.000", SPH_READ_ELEMENT},
    {"a.pdb", CA, "end", SPH_READ_NO_ATOM},
    {"a.cif", LOOP "0 0 0 C 1\n", "1 2 3 C 1", SPH_READ_ATOM},
    {"a.cif", LOOP "0 0 0 C 1\n", "_cell.length_a 1", SPH_READ_NO_ATOM},
    {"a.cif", LOOP "0 0 0 C 1\n", "loop_ _a.b 1", SPH_READ_NO_ATOM},
    {"a.cif", LOOP "0 0 0 C 1\n", "_chem_comp_bond.comp_id ALA", SPH_READ_BONDS},
    {"a.cif", LOOP "0 0 0 C 1\n", "_struct_conn.conn_type_id covale", SPH_READ_BONDS},
    {"a.xyz", "1\n\nC 0 0 0\n", "1", SPH_READ_MODEL},
    {"a.csv", "x y z r\n0 0 0 1\n", "1 0 0 1", SPH_READ_SPHERE},
};

/* How many records there are of a text, and of one kind of them. -1: it is refused. */
static int64_t count_of(const struct word *word, int whole, int64_t *of_kind) {
    char text[1000];
    struct sph_error err = {""};
    struct row row = {.name = word->name, .text = text};
    snprintf(text, sizeof text, whole ? "%s%s\n" : "%s", word->before, word->record);
    struct sph_ledger ledger = ledger_of(&row, 0, &err);
    int64_t n = 0;
    for (int kind = 0; kind < SPH_READS; kind++)
        n += (int64_t)ledger.row[kind].n;
    *of_kind = (int64_t)ledger.row[word->kind].n;
    if (whole && err.text[0]) fail_msg("`%s`: %s", word->record, err.text);
    return err.text[0] ? -1 : n;
}

static void test_words(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        int64_t kind, kind_without, n = count_of(&words[i], 1, &kind);
        int64_t without = count_of(&words[i], 0, &kind_without);
        if (without < 0) without = kind_without = 0; /* there is nothing before it */
        if (kind <= kind_without || n <= without || n > without + 2)
            fail_msg("%s: `%s`: %d records of its kind, %d before it; %d and %d of all",
                     words[i].name, words[i].record, (int)kind, (int)kind_without, (int)n,
                     (int)without);
    }
}

/* What build leaves out counts once: as left out, unless something of its record is left. */
static void test_once(void **state) {
    static const struct {
        const char *text;
        enum sph_read used, out;
        uint64_t n_used, n_out;
    } once[] = {
        {CAM MATT SPH "s 0 0 1e-9 1\n", SPH_READ_SPHERE, SPH_READ_SPHERE_GRID, 1, 1},
        {CAM MATT SPH "s 2 0 0 1e-9\n", SPH_READ_SPHERE, SPH_READ_SPHERE_SMALL, 1, 1},
        {CAM MATT "p 3 0 0 0 1 0 0 0 1 0\np 3 0 0 0 1 0 0 0 1 0\n", SPH_READ_POLYGON,
         SPH_READ_TRIANGLE_TWICE, 1, 1},
        /* of this polygon the second triangle is left out, the first is not */
        {CAM MATT "p 4 0 0 0 1 0 0 1 1 0 1e-9 1e-9 0\n", SPH_READ_POLYGON, SPH_READ_NO_AREA_GRID, 1,
         1},
        {CAM MATT "p 3 0 0 0 1 0 0 0 1 0\ntt none 0 0 0 0 0 1e-9 0 0 0 0 0 1 0 0 0\n",
         SPH_READ_TRIANGLE, SPH_READ_NO_AREA_GRID, 0, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof once / sizeof *once; i++) {
        const struct row row = {SPH_READ_SPHERE, "a.nff", once[i].text, 0, BUILD};
        struct sph_error err = {""};
        struct sph_ledger ledger = ledger_of(&row, 0, &err);
        if (err.text[0]) fail_msg("case %zu: %s", i, err.text);
        if (ledger.row[once[i].used].n != once[i].n_used ||
            ledger.row[once[i].out].n != once[i].n_out)
            fail_msg("case %zu: %llu used, %llu left out", i,
                     (unsigned long long)ledger.row[once[i].used].n,
                     (unsigned long long)ledger.row[once[i].out].n);
    }
}

/* What is printed: from an end on, the first of each kind, and how many. */
static void test_print(void **state) {
    (void)state;
    struct sph_ledger ledger = {0};
    struct sph_error err = {""};
    char text[400] = "";
    FILE *to = fmemopen(text, sizeof text, "w");
    sph_ledger_note(&ledger, SPH_READ_SPHERE, "a.nff", 7, &err);
    sph_ledger_note(&ledger, SPH_READ_NO_AREA, "a.nff", 9, &err);
    sph_ledger_note(&ledger, SPH_READ_NO_AREA, "a.nff", 8, &err);
    sph_ledger_add(&ledger, SPH_READ_GLASS_MEETS, 1, "a.nff", 5, 3, &err);
    sph_ledger_print(&ledger, SPH_USED_OTHERWISE, "> ", to);
    fclose(to);
    assert_string_equal(text, "> a.nff:5: used otherwise: glass that cuts the surface of other "
                              "glass: drawn as if each stood in air, with that of line 3, 1 time\n"
                              "> a.nff:9: left out: triangle or polygon without area, 2 times\n");
    assert_int_equal(sph_ledger_left_out(&ledger), 2);
    assert_int_equal(err.text[0], 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows), cmocka_unit_test(test_words),
                                       cmocka_unit_test(test_once), cmocka_unit_test(test_print)};
    return cmocka_run_group_tests_name("ledger", tests, make_folder, remove_folder);
}
