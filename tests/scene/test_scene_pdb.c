/* test_scene_pdb.c - molecules: atoms, bonds, colours, packed files
 * SPDX-License-Identifier: Apache-2.0
 *
 * Radii come from the Debian package bodr, proteins from pymol-data.
 */
#include "scene_files.h"

#include <math.h>
#include <sys/stat.h>
#include <zlib.h>

#include "scene/elements.h"
#include "scene/import.h"

#define PYMOL "/usr/share/pymol/data/"

#define ATOM(name, loc, residue, x, y, z, element)                                                 \
    "ATOM      1 " name loc residue " A   1    " x y z "  1.00  0.00          " element "\n"

static void test_pdb_small(void **state) {
    (void)state;
    struct sph_error err = {""};
    struct sph_import_options o = {0};
    struct sph_scene s;
    const char text[] = "MODEL        1\n" ATOM(
        " CA ", "A", "ALA", "   1.000", "   2.000", "   3.000",
        " C") ATOM(" CA ", "B", "ALA", "   1.500", "   2.000", "   3.000", " C")
        ATOM(" N  ", " ", "ALA", "   1.000", "   2.000", "   3.000", " N") ATOM(
            "HG11", " ", "VAL", "  -1.000", "   2.000", "   3.000",
            "  ") "HETATM    1 CA    CA A   1       0.000   0.000   0.000  1.00  0.00\n"
                  "HETATM    1 ZN    ZN A   1       5.000   0.000   0.000  1.00  0.00          "
                  "ZN2+\n"
                  "HETATM    1  O   HOH A   1       7.000   0.000   0.000  1.00  0.00           O\n"
                  "ENDMDL\nMODEL        2\n" ATOM(" O  ", " ", "ALA", "   9.000", "   2.000",
                                                  "   3.000", " O");
    put_file(text, sizeof text - 1);
    if (sph_import(file_name, SPH_FILE_PDB, &o, &s, &err)) fail_msg("%s", err.text);
    const struct sph_ledger_row *row = s.ledger.row;
    assert_int_equal(s.n_spheres, 4);
    assert_int_equal(row[SPH_READ_WATER].n, 1);
    assert_int_equal(row[SPH_READ_ALTERNATE].n, 1);
    assert_int_equal(row[SPH_READ_OTHER_PLACE].n, 1);
    assert_int_equal(row[SPH_READ_SAME_PLACE].n, 1);
    assert_int_equal(row[SPH_READ_MODEL].n, 1);
    static const double rads[] = {1.7, 1.2, 2.4, 2.1}; /* C, H, Ca, Zn: Blue Obelisk */
    for (uint32_t i = 0; i < 4; i++)
        assert_true(s.spheres[i].rad == rads[i]);
    assert_int_equal(s.spheres[3].line, 7);
    sph_scene_free(&s);
    o.keep_water = 1;
    assert_int_equal(sph_import(file_name, SPH_FILE_PDB, &o, &s, &err), 0);
    assert_int_equal(s.n_spheres, 5);
    round_trip(&s);
    sph_scene_free(&s);
}

#define X10(s) s s s s s s s s s s
#define X100(s) X10(X10(s))

/* Ions as AMBER and others name them, without columns 77 and 78. */
static void test_pdb_ions(void **state) {
    (void)state;
    static const struct {
        const char *record, *name, *residue, *element;
    } ions[] = {
        {"ATOM  ", "Na+ ", "Na+", "Na"}, {"ATOM  ", " Na+", "Na+", "Na"},
        {"HETATM", "Cl- ", "Cl-", "Cl"}, {"ATOM  ", " K+ ", "K+ ", "K"},
        {"ATOM  ", "MG2 ", "MG2", "Mg"}, {"ATOM  ", "Zn2+", "ZN ", "Zn"},
        {"ATOM  ", "Cs+ ", "CIO", "Cs"}, {"ATOM  ", "NA  ", "Na+", "Na"},
        {"ATOM  ", "CA  ", "CA ", "Ca"}, {"ATOM  ", " CA ", "ALA", "C"},
        {"ATOM  ", " N1+", "LIG", "N"},  {"HETATM", "CL1 ", "LIG", "Cl"},
        {"ATOM  ", " C2 ", "  C", "C"},  {"ATOM  ", " O5'", "DA5", "O"},
    };
    enum { IONS = sizeof ions / sizeof *ions };
    char text[100 * IONS];
    size_t n = 0;
    struct sph_error err = {""};
    struct sph_elements elements;
    struct sph_scene s;
    for (int i = 0; i < IONS; i++)
        n += (size_t)sprintf(text + n, "%s    1 %s %s     1    %8d   0.000   0.000  1.00  0.00\n",
                             ions[i].record, ions[i].name, ions[i].residue, 5 * i);
    put_file(text, n);
    if (sph_import(file_name, SPH_FILE_PDB, NULL, &s, &err)) fail_msg("%s", err.text);
    assert_int_equal(sph_elements_read(SPH_ELEMENTS_PATH, &elements, &err), 0);
    assert_int_equal(s.n_spheres, IONS);
    for (int i = 0; i < IONS; i++) {
        const struct sph_element *e = &elements.list[sph_elements_find(&elements, ions[i].element)];
        const double *rgb = s.materials[s.spheres[i].material].rgb;
        if (s.spheres[i].rad != e->rad || memcmp(rgb, e->rgb, sizeof e->rgb) != 0)
            fail_msg("%s of %s is not %s", ions[i].name, ions[i].residue, ions[i].element);
    }
    sph_scene_free(&s);
}

#define LINE(serial, name, residue, chain, number, x, element)                                     \
    "ATOM  " serial " " name " " residue " " chain number "    " x                                 \
    "   0.000   0.000  1.00  0.00          " element "\n"
#define CIF(items, rows) "data_x\nloop_\n" items rows
#define PLACES "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
#define IDS                                                                                        \
    PLACES "_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"          \
           "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n"
#define CONN                                                                                       \
    "loop_\n_struct_conn.conn_type_id\n_struct_conn.ptnr1_auth_asym_id\n"                          \
    "_struct_conn.ptnr1_auth_seq_id\n_struct_conn.ptnr1_label_atom_id\n"                           \
    "_struct_conn.ptnr2_auth_asym_id\n_struct_conn.ptnr2_auth_seq_id\n"                            \
    "_struct_conn.ptnr2_label_atom_id\n"
#define COMP                                                                                       \
    "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n"

/* What becomes of files, as balls and sticks: two cones a bond, one between atoms of one colour. */
static const struct molecule {
    enum sph_file_kind kind;
    enum sph_atom_colour colour;
    uint32_t spheres, cones, materials;
    const char *text;
} molecules[] = {
    /* hybrid-36: serials and residue numbers behind 99999 and 9999; metals bond as the file says */
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 2, 2, 2,
     LINE("A0000", " NA ", "ION", "A", "A000", "   0.000", "NA")
         LINE("A0001", " C  ", "ION", "A", "A001", "   2.000", " C") "CONECTA0000A0001\n"},
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 2, 0, 2,
     LINE("A0000", " NA ", "ION", "A", "A000", "   0.000", "NA")
         LINE("A0001", " C  ", "ION", "A", "A001", "   2.000", " C")},
    /* alternates of hybrid-36 residues are those of one residue */
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 2, 0, 1,
     LINE("A0000", " CA A", "LA", "A", "ZZZZ", "   0.000", " C")
         LINE("A0001", " CA B", "LA", "A", "ZZZZ", "   1.000", " C")
             LINE("A0002", " CA A", "LA", "A", "a000", "   5.000", " C")},
    /* serials of seven digits shift their columns, and CONECT has blanks between */
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 2, 1, 1,
     LINE("1000000", " NA ", "ION", "A", "   1", "   0.000", "NA")
         LINE("1000001", " NA ", "ION", "A", "   2", "   4.000", "NA") "CONECT1000000 1000001\n"},
    /* a bond given twice and told by distance is one */
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 2, 1, 1,
     LINE("    1", " C1 ", "LIG", "A", "   1", "   0.000", " C")
         LINE("    2", " C2 ", "LIG", "A", "   1", "   1.500", " C") "CONECT    1    2    2\n"
                                                                     "CONECT    2    1\n"},
    /* 0.77 + 0.77 + 0.4 Angstrom is the longest bond of two carbons; 0.4 no bond any more */
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 1, 1, "2\n\nC 0 0 0\nC 0 0 1.94\n"},
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 0, 1, "2\n\nC 0 0 0\nC 0 0 1.95\n"},
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 0, 1, "2\n\nC 0 0 0\nC 0 0 .39\n"},
    /* across cells, also of those that share a number; hydrogens of one carbon do not bond */
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 5, 8, 2,
     "5\nmethane\nC 0 0 0\nH .63 .63 .63\nH -.63 -.63 .63\nH -.63 .63 -.63\nH .63 -.63 -.63\n"},
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 0, 1, "2\n\nC 0 0 0\nC 4068474.88 0 0\n"},
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 0, 2, "2\n\nC 0 0 0\nNa 0 0 2\n"},
    /* of two atoms at one place one is bonded */
    {SPH_FILE_XYZ, SPH_COLOUR_ELEMENT, 2, 1, 1, "3\n\nC 0 0 0\nC 0 0 0\nC 0 0 1.5\n"},
    /* names that all begin in column 13 */
    {SPH_FILE_PDB, SPH_COLOUR_ELEMENT, 3, 0, 2,
     LINE("    1", "CA  ", "ALA", "A", "   1", "   0.000", "  ")
         LINE("    2", "CL1 ", "LIG", "A", "   2", "   5.000", "  ")
             LINE("    3", "C1  ", "LIG", "A", "   3", "   9.000", "  ")},
    {SPH_FILE_PDB, SPH_COLOUR_RESIDUE, 3, 0, 2, /* aspartate and glutamate are red */
     LINE("    1", " CA ", "ASP", "A", "   1", "   0.000", " C")
         LINE("    2", " CA ", "GLU", "A", "   2", "   5.000", " C")
             LINE("    3", " CA ", "LYS", "A", "   3", "   9.000", " C")},
    {SPH_FILE_PDB, SPH_COLOUR_CHAIN, 3, 0, 2,
     LINE("    1", " CA ", "ASP", "A", "   1", "   0.000", " C")
         LINE("    2", " CA ", "ASP", "B", "   1", "   5.000", " C")
             LINE("    3", " N  ", "LYS", "A", "   2", "   9.000", " N")},
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 2, 2, 2,
     CIF(IDS, "0 0 0 Zn ZN ZN A 1\n3 0 0 S SG CYS A 2\n") CONN "metalc A 1 ZN A 2 SG\n"},
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 2, 0, 2,
     CIF(IDS, "0 0 0 Zn ZN ZN A 1\n3 0 0 S SG CYS A 2\n") CONN "hydrog A 1 ZN A 2 SG\n"},
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 3, 2, 2, /* the bond of its residue alone */
     CIF(IDS, "0 0 0 Zn ZN ZZZ A 1\n3 0 0 S \"S'\" ZZZ A 1\n9 0 0 Zn ZN YYY A 2\n") COMP
     "ZZZ ZN \"S'\"\nYYY ZN \"S'\"\n"},
    /* chains and numbers of the archive where the authors' are missing */
    {SPH_FILE_CIF, SPH_COLOUR_CHAIN, 2, 0, 2,
     CIF(PLACES "_atom_site.type_symbol\n_atom_site.label_asym_id\n", "0 0 0 C A\n9 0 0 C B\n")},
    /* one atom as single items; digits' errors; in the second block another model */
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 1, 0, 1,
     "data_x\n_atom_site.Cartn_x 1.5(2)\n_atom_site.Cartn_y 2\n_atom_site.type_symbol C\n"
     "_atom_site.Cartn_z 3(10)\ndata_y\nloop_\n" PLACES "_atom_site.type_symbol\n0 0 0 C\n"},
    /* rows behind whose names values follow on their lines */
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 2, 1, 1,
     CIF("_atom_site.group_PDB\n_atom_site.type_symbol\n" PLACES,
         "ATOM C 0 0 0 1 2\nHETATM C 0 0 1.5 7 ATOM_X ?\n")},
    {SPH_FILE_CIF, SPH_COLOUR_ELEMENT, 2, 1, 1, /* two rows on a line are two */
     CIF("_atom_site.group_PDB\n_atom_site.type_symbol\n" PLACES,
         "ATOM C 0 0 0 HETATM C 0 0 1.5\n")},
};

static void test_molecules(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof molecules / sizeof *molecules; i++) {
        const struct molecule *m = &molecules[i];
        const struct sph_import_options o = {.colour = m->colour, .sticks = 1};
        struct sph_error err = {""};
        struct sph_scene s;
        put_file(m->text, strlen(m->text));
        if (sph_import(file_name, m->kind, &o, &s, &err)) fail_msg("row %zu: %s", i, err.text);
        if (s.n_spheres != m->spheres || s.n_frusta != m->cones || s.n_materials != m->materials)
            fail_msg("row %zu: %u spheres, %u cones, %u materials", i, s.n_spheres, s.n_frusta,
                     s.n_materials);
        round_trip(&s);
        sph_scene_free(&s);
    }
}

/* What gzip has packed is read as it was; what it has not, or not whole, is refused. */
static void test_packed(void **state) {
    (void)state;
    static const struct {
        const char *text;
        enum sph_file_kind kind;
        int cut; /* bytes that are missing at the end */
        const char *says;
    } files[] = {
        {CIF(IDS, "0 0 0 C CA ALA A 1\n"), SPH_FILE_CIF, 0, NULL},
        {LINE("    1", " CA ", "ALA", "A", "   1", "   0.000", " C"), SPH_FILE_PDB, 0, NULL},
        {CAM MAT "s 0 0 0 1\n", SPH_FILE_NFF, 0, NULL},
        {LINE("    1", " CA ", "ALA", "A", "   1", "   0.000", " C"), SPH_FILE_PDB, 9, "cut off"},
        {"BM and more", SPH_FILE_OTHER, 0, "a file packed by gzip: unpack it first"},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct sph_error err = {""};
        struct sph_scene s;
        struct stat about;
        gzFile out = gzopen(file_name, "wb");
        assert_true(gzputs(out, files[i].text) > 0);
        assert_int_equal(gzclose(out), Z_OK);
        assert_int_equal(stat(file_name, &about), 0);
        assert_int_equal(truncate(file_name, about.st_size - files[i].cut), 0);
        if (!files[i].cut) assert_int_equal(sph_file_kind(file_name, NULL), files[i].kind);
        int rc = files[i].cut ? sph_import(file_name, files[i].kind, NULL, &s, &err)
                              : sph_scene_read(file_name, NULL, &s, &err);
        if (rc != (files[i].says ? -1 : 0) || (rc && !strstr(err.text, files[i].says)))
            fail_msg("file %zu: %s", i, err.text);
        if (rc) continue;
        assert_int_equal(s.n_spheres, 1);
        sph_scene_free(&s);
    }
}

static const struct bad bad_pdbs[] = {
    {"pdb_coordinate",
     "REMARK\n" ATOM(" C  ", " ", "ALA", "   1.0a0", "   2.000", "   3.000", " C"), 2,
     "x (columns 31-38): `1.0a0`", 0, 0},
    {"pdb_blank_coordinate", ATOM(" C  ", " ", "ALA", "   1.000", "   2.000", "        ", " C"), 1,
     "z (columns 47-54)", 0, 0},
    {"pdb_nan", ATOM(" C  ", " ", "ALA", "     nan", "   2.000", "   3.000", " C"), 1,
     "x (columns 31-38)", 0, 0},
    {"pdb_short_line", "ATOM      1  C   ALA A   1       1.000   2.000", 1, "column 54", 0, 0},
    {"pdb_element", ATOM("??? ", " ", "XXX", "   1.000", "   2.000", "   3.000", "  "), 0,
     "no atoms other than 0 of water (kept by --water), 1 of no known element", 0, 0},
    {"pdb_ion", ATOM("Xq+ ", " ", "Xq+", "   1.000", "   2.000", "   3.000", "  "), 0,
     "1 of no known element", 0, 0},
    {"pdb_nul", "ATOM  \0\n", 1, "byte 0x00", 0, 8},
    {"pdb_long_line",
     "REMARK\n" X100("0123456789") X100("0123456789") X100("0123456789") X100("0123456789") "0\n",
     2, "more than 4000 characters", 0, 0},
    {"pdb_no_atom", "REMARK\nEND\n", 0, "no atoms", 0, 0},
    {"pdb_empty", "", 0, "no atoms", 0, 0},
};

static void test_bad_pdb(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene s;
    put_bad(bad);
    assert_int_equal(sph_import(file_name, SPH_FILE_PDB, NULL, &s, &err), -1);
    assert_message(bad, &err);
    assert_null(s.spheres);
}

static void test_pdb_files_missing(void **state) {
    (void)state;
    struct sph_error err = {""}, err2 = {""}, err3 = {""};
    struct sph_import_options o = {.elements_path = "/nowhere/elements.xml"};
    struct sph_scene s;
    assert_int_equal(sph_import("/nowhere/x.pdb", SPH_FILE_PDB, NULL, &s, &err), -1);
    assert_non_null(strstr(err.text, "/nowhere/x.pdb: cannot open"));
    assert_int_equal(sph_import(PYMOL "demo/pept.pdb", SPH_FILE_PDB, &o, &s, &err2), -1);
    assert_non_null(strstr(err2.text, "Debian package bodr"));
    const char xml[] = "<list>\n<atom id='C'></list>";
    put_file(xml, sizeof xml - 1);
    o.elements_path = file_name;
    assert_int_equal(sph_import(PYMOL "demo/pept.pdb", SPH_FILE_PDB, &o, &s, &err3), -1);
    assert_non_null(strstr(err3.text, "scene.nff:2: mismatched tag"));
}

/* Real proteins: the number of atoms, every sphere in view, no two at one place. */
static void test_pdb_proteins(void **state) {
    (void)state;
    static const struct {
        const char *path;
        uint32_t atoms, waters;
    } files[] = {{PYMOL "tut/1hpv.pdb", 1551, 80},
                 {PYMOL "demo/il2.pdb", 2084, 0},
                 {PYMOL "demo/1tii.pdb", 5469, 215},
                 {PYMOL "demo/pept.pdb", 107, 0}};
    for (int i = 0; i < 4; i++) {
        struct sph_error err = {""};
        struct sph_import_options o = {.width = 64, .height = 48};
        struct sph_scene s;
        if (sph_import(files[i].path, SPH_FILE_PDB, &o, &s, &err)) fail_msg("%s", err.text);
        assert_int_equal(s.n_spheres, files[i].atoms);
        assert_int_equal(s.ledger.row[SPH_READ_WATER].n, files[i].waters);
        const struct sph_vec f = s.camera.from, a = s.camera.at, u = s.camera.up;
        double dist = hypot(hypot(f.x - a.x, f.y - a.y), f.z - a.z), t = tan(M_PI / 12);
        for (uint32_t k = 0; k < s.n_spheres; k++) {
            const struct sph_vec c = s.spheres[k].ctr, d = {c.x - f.x, c.y - f.y, c.z - f.z};
            double ahead = (d.x * (a.x - f.x) + d.y * (a.y - f.y) + d.z * (a.z - f.z)) / dist;
            double high = fabs(d.x * u.x + d.y * u.y + d.z * u.z);
            assert_true(high + s.spheres[k].rad < ahead * t);
        }
        round_trip(&s);
        sph_scene_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_pdb_small),         cmocka_unit_test(test_pdb_ions),
        cmocka_unit_test(test_molecules),         cmocka_unit_test(test_packed),
        cmocka_unit_test(test_pdb_files_missing), cmocka_unit_test(test_pdb_proteins)};
    return run_cases("scene_pdb", test_bad_pdb, bad_pdbs, sizeof bad_pdbs / sizeof bad_pdbs[0],
                     others, sizeof others / sizeof others[0]);
}
