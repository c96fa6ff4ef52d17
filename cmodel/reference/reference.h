/* reference.h - the same picture in double precision, from the scene as written
 * SPDX-License-Identifier: Apache-2.0
 *
 * Nothing is quantised before the final 8-bit colour: what a machine's frame differs by is the
 * price of its number formats. Shading rules are those of the machine (docs/design/model.md).
 */
#ifndef SPH_REFERENCE_H
#define SPH_REFERENCE_H

#include <stdint.h>

#include "common/error.h"
#include "common/parallel.h"
#include "core/frame.h"
#include "machine/machine.h"
#include "reference/texture.h"
#include "reference/tree.h"
#include "scene/scene.h"

struct sph_reference_options {
    int width, height;     /* pixels; 0: as the scene says */
    int max_depth;         /* reflections followed, 0..10 */
    int shadow;            /* 1: lights are blocked */
    int reflect;           /* 1: mirrors are followed */
    int refract, specular; /* 1: refracted rays are followed; highlights */
    int unlimited;         /* 1: a surface may be brighter than 1 until pixels are written */
    int total;             /* 1: what is totally reflected is not lessened */
    int threads;           /* 0: all */
    const struct sph_machine
        *world;                 /* NULL, or pixels are marked that see planes in a wrong light */
    const struct sph_mip *mips; /* images of the scene; NULL: none are shown */
    int filter, lod;            /* SPH_FILTER_*; SPH_LOD_*: the level that colours see */
    int spread;                 /* 1: spheres spread what SPH_LOD_MENDED goes by, as with SPREAD */
    int kd;                     /* 1: rays go through a kd-tree */
    struct sph_ref_work *work;  /* NULL, or what the tree does, with one thread */
    const uint32_t *places;     /* NULL: every pixel; else these alone, y * width + x, */
    uint32_t n_places;          /* and what comes out is n_places x 1 */
    const struct sph_progress *progress; /* NULL: nobody asks */
};

struct sph_reference_pixel {
    uint32_t colour[SPH_FRAMES]; /* 0xBBGGRR at depth 0, 1 and the deepest, as sph_pixel */
    uint32_t id;                 /* sphere or facet seen, SPH_ID_NONE: background */
    uint32_t reflected_id;       /* seen in it; SPH_ID_NONE: none */
    uint32_t refracted_id;       /* seen through it; SPH_ID_NONE: none */
    uint32_t faced;              /* bit l: light l shines on the side of it that is seen */
    uint32_t shadow;             /* bit l: light l does, but is blocked */
    int beyond;                  /* SPH_BEYOND_*: a plane is seen far beyond the world */
    int doubt;                   /* doubles cannot tell what is seen, also by later rays */
    double distance;             /* from the eye to it, scene units; INFINITY: background */
    int textured;                /* a surface with an image is seen, also in mirrors */
    double lod[SPH_LODS];        /* of the first one, each way */
    int via;                     /* SPH_VIA_*: how that one is seen */
    double facing;               /* cosine of its normal and the ray */
};

/* By the eye (its bit), by a ray that leaves a surface. */
enum { SPH_BEYOND_EYE = 1, SPH_BEYOND_LATER = 2 };

/* How a textured surface is seen: directly, in flat mirrors, in at least one curved one. */
enum { SPH_VIA_NOTHING, SPH_VIA_FLAT, SPH_VIA_CURVED, SPH_VIAS };

struct sph_reference {
    int width, height;
    struct sph_reference_pixel *pixels; /* row by row, row 0 on top */
    struct sph_level_work work;         /* of all textured hits */
};

struct sph_image_error {
    double psnr[SPH_FRAMES]; /* dB over all channels; INFINITY: equal, or all undecidable */
    uint64_t pixels;         /* compared */
    uint64_t undecidable;    /* of these: a last bit of a double decides; not in dB, nor below */
    uint64_t silhouette;     /* hit in one, background in the other */
    uint64_t wrong_id;       /* hit in both, another one */
    uint64_t far_off;        /* a channel of the deepest layer is off by more than 8 */
    int worst;               /* largest difference of a channel in the deepest layer */
};

/* Renders the scene into *out (allocated here). 0, or -1 with a message (no memory, a camera
 * without direction, a size that is not positive). */
int sph_reference_render(const struct sph_scene *scene, const struct sph_reference_options *options,
                         struct sph_reference *out, struct sph_error *err);

void sph_reference_free(struct sph_reference *r);

/* Compares two frames of equal size (sizes differ: pixels is 0 and nothing else counts). The ids
 * of the frame must be the scene's numbers: spheres, then facets. */
struct sph_image_error sph_reference_compare(const struct sph_frame *frame,
                                             const struct sph_reference *reference);

#endif
