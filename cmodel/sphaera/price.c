/* price.c - what accuracy costs, of the library: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>

#include "image/mips.h"
#include "sphaera/opaque.h"
#include "trial/price.h"

struct sphaera_price {
    struct sph_price price;
};

static int measure(const struct sph_scene *scene, struct sph_build_options *o,
                   const struct sph_price_options *how, struct sph_price *to,
                   struct sph_error *err) {
    struct sph_mip *mips = NULL;
    if (o->texture != SPH_OFF && sph_mips_load(scene, &mips, err)) return -1;
    o->mips = mips;
    int rc = sph_price_make(scene, o, how, to, err);
    sph_mips_free(mips, scene->n_textures);
    return rc;
}

int sphaera_price_measure(const sphaera_scene *scene, const sphaera_build_options *options,
                          double keep_pixels, double keep_psnr, uint32_t most,
                          sphaera_price **price, sphaera_error *error) {
    if (sph_api_null(scene, "scene", error) || sph_api_null(price, "price", error)) return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct sph_api_build b;
    struct sph_scene aimed;
    *price = NULL;
    b.told.end = 0;
    if (!(keep_pixels >= 0 && keep_psnr >= 0)) {
        sph_fail(&err, "to keep %g pixels and %g dB: these are 0 or more", keep_pixels, keep_psnr);
        return sph_api_failed(&err, error);
    }
    int asked = keep_pixels > 0 || keep_psnr > 0;
    struct sph_price_options how = {.bound = {asked ? keep_pixels : SPH_ERROR_BOUND_PIXELS,
                                              asked ? keep_psnr : SPH_ERROR_BOUND_PSNR},
                                    .most = most};
    sphaera_price *made = calloc(1, sizeof *made);
    int rc = made ? sph_api_options(options, &b, &err) : sph_fail(&err, "no memory for a table");
    if (!rc) rc = sph_api_frame(&scene->scene, &b, &aimed, &err);
    if (!rc) {
        how.only = b.o.widths;
        rc = measure(&aimed, &b.o, &how, &made->price, &err);
    }
    if (!rc) {
        *price = made;
        return 0;
    }
    free(made);
    if (b.told.end) snprintf(err.text, sizeof err.text, "cancelled");
    return sph_api_failed(&err, error);
}

void sphaera_price_free(sphaera_price *price) {
    free(price);
}

int sphaera_price_rows(const sphaera_price *price) {
    return price->price.n;
}

int sphaera_price_best(const sphaera_price *price) {
    return price->price.best;
}

int sphaera_price_get(const sphaera_price *price, int number, sphaera_price_row *row) {
    if (!price || !row || number < 0 || number >= price->price.n) return -1;
    const struct sph_price_row *r = &price->price.row[number];
    *row = (sphaera_price_row){.name = r->name, .why = r->built ? NULL : r->why};
    if (!r->built) return 0;
    const struct sph_image_error *e = &r->accuracy.image;
    row->psnr = e->psnr[SPH_FRAMES - 1];
    row->psnr_least = r->psnr_least;
    row->psnr_expected = r->expected.fits ? r->expected.psnr : 0;
    row->pixels = e->pixels;
    row->undecidable = e->undecidable;
    row->wrong = r->wrong;
    row->wrong_most = r->wrong_most;
    row->keeps = r->keeps;
    row->cycles_per_pixel = r->cycles.pixel;
    if (!r->known.cells_estimated) {
        row->lut4eq = r->known.lut4eq;
        row->mult = r->known.mult;
        row->bram = r->known.bram;
    }
    if (r->known.clock_estimated) return 0;
    row->mhz = r->known.median;
    row->milliseconds = r->milliseconds;
    return 0;
}
