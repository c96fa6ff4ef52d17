/* atom_colours.c - colours of atoms by element, residue or chain; see atoms.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Residues have the colours of RasMol's "amino" (R. Sayle), bases of nucleic acids those of its
 * "shapely". Chains take hues that are a golden angle apart, so that neighbours differ.
 */
#include <math.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "scene/atoms.h"
#include "scene/edit.h"

static const struct {
    const char *names; /* between blanks */
    uint8_t rgb[3];
} residues[] = {
    {" ASP GLU ", {230, 10, 10}},
    {" CYS MET CYX ", {230, 230, 0}},
    {" LYS ARG ", {20, 90, 255}},
    {" SER THR ", {250, 150, 0}},
    {" PHE TYR ", {50, 50, 170}},
    {" ASN GLN ", {0, 220, 220}},
    {" GLY ", {235, 235, 235}},
    {" LEU VAL ILE ", {15, 130, 15}},
    {" ALA ", {200, 200, 200}},
    {" TRP ", {180, 90, 180}},
    {" HIS HID HIE HIP HSD HSE HSP ", {130, 130, 210}},
    {" PRO ", {220, 150, 130}},
    {" A DA DA3 DA5 ", {160, 160, 255}},
    {" C DC DC3 DC5 ", {255, 140, 75}},
    {" G DG DG3 DG5 ", {255, 112, 112}},
    {" T DT DT3 DT5 ", {160, 255, 160}},
    {" U DU ", {255, 128, 128}},
    {"", {190, 160, 110}}, /* all others */
};
enum { RESIDUES = sizeof residues / sizeof *residues };

static int residue_of(const char *name) {
    char word[sizeof((struct sph_atom *)0)->residue + 2];
    int i = 0;
    snprintf(word, sizeof word, " %s ", name);
    while (i < RESIDUES - 1 && !strcasestr(residues[i].names, word))
        i++;
    return i;
}

/* Chains beyond these have the colours of the first ones again. */
enum { HUES = 64 };

struct chain {
    char name[sizeof((struct sph_atom *)0)->chain];
    int number;
};

static int by_name(const void *a, const void *b) {
    return strcmp(((const struct chain *)a)->name, ((const struct chain *)b)->name);
}

/* Number of the chain, in the order in which they come; -1: no memory. */
static int chain_of(struct sph_atom_colours *colours, const char *name) {
    struct chain asked = {.number = (int)(colours->n_chains % HUES)}, **found;
    memcpy(asked.name, name, sizeof asked.name);
    found = tfind(&asked, &colours->chains, by_name);
    if (found) return (*found)->number;
    struct chain *made = malloc(sizeof *made);
    if (!made || (*made = asked, !tsearch(made, &colours->chains, by_name))) {
        free(made);
        return -1;
    }
    colours->n_chains++;
    return asked.number;
}

void sph_atom_colours_free(struct sph_atom_colours *colours) {
    tdestroy(colours->chains, free);
}

/* A light colour of this hue, 0..1. */
static void colour_of_hue(double hue, double rgb[3]) {
    const double least = 0.25, most = 0.9;
    for (int i = 0; i < 3; i++) {
        double x = fabs(fmod(6 * hue + 8 - 2 * i, 6) - 3) - 1; /* of a hexagon of hues */
        rgb[i] = least + (most - least) * fmin(fmax(x, 0), 1);
    }
}

int sph_atom_material(struct sph_atom_colours *colours, const struct sph_atom *atom,
                      const struct sph_element *element, int number, struct sph_scene *scene,
                      uint32_t *material, struct sph_error *err) {
    static const double golden = 0.61803398874989485; /* of a turn */
    struct sph_material m = {{0}, 0.85, 0.15, 30, 0, 1, 0, {0}, 0};
    if (colours->by == SPH_COLOUR_RESIDUE) number = residue_of(atom->residue);
    if (colours->by == SPH_COLOUR_CHAIN) number = chain_of(colours, atom->chain);
    if (number < 0) return sph_fail(err, "%s: no memory for its chains", scene->path);
    uint32_t *made = &colours->material[number];
    if (!*made) {
        if (colours->by == SPH_COLOUR_CHAIN) colour_of_hue(fmod(number * golden, 1), m.rgb);
        for (int i = 0; i < 3 && colours->by != SPH_COLOUR_CHAIN; i++)
            m.rgb[i] = colours->by == SPH_COLOUR_ELEMENT ? element->rgb[i]
                                                         : residues[number].rgb[i] / 255.0;
        if (sph_scene_add_material(scene, &m, err)) return -1;
        *made = scene->n_materials;
    }
    *material = *made - 1;
    return 0;
}
