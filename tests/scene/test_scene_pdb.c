/* test_scene_pdb.c - PDB import
 * SPDX-License-Identifier: Apache-2.0
 *
 * Radii come from the Debian package bodr, proteins from pymol-data.
 */
#include "scene_files.h"

#include <math.h>

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
        cmocka_unit_test(test_pdb_small), cmocka_unit_test(test_pdb_ions),
        cmocka_unit_test(test_pdb_files_missing), cmocka_unit_test(test_pdb_proteins)};
    return run_cases("scene_pdb", test_bad_pdb, bad_pdbs, sizeof bad_pdbs / sizeof bad_pdbs[0],
                     others, sizeof others / sizeof others[0]);
}
