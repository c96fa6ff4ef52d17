/* options.c - what is built, as users say it and as the builder takes it: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "builder/background/background.h"
#include "builder/background/spans.h"
#include "common/number.h"
#include "sphaera/opaque.h"
#include "texture/lookup.h"

enum { MOST_SAMPLES = 16, LEVELS_MOST = SPH_BIH_STACK + 1 };

void sphaera_build_init(sphaera_build_options *options) {
    const struct sph_build_options o = SPH_BUILD_DEFAULT;
    *options = (sphaera_build_options){.size = sizeof *options,
                                       .profile = "auto",
                                       .accel = "auto",
                                       .depth = o.max_depth,
#define ASK(NAME, word, core, bit, most, all, option, ...) ASK_##option(word)
#define ASK_SPH_OPTION_WHEN(word) .word = SPHAERA_AUTO,
#define ASK_SPH_OPTION_OFF ASK_SPH_OPTION_WHEN
#define ASK_SPH_OPTION_COUNT ASK_SPH_OPTION_WHEN
#define ASK_SPH_OPTION_NONE(word)
                                       SPH_EACH_EFFECT(ASK).effects = "all",
                                       .tree = "reinserted",
                                       .axes = "auto",
                                       .bih = "full",
                                       .background = "none",
                                       .bg_border = o.bg_border,
                                       .traverse = "nearest",
                                       .filter = "between",
                                       .lod = "mended",
                                       .lod_bits = SPH_LOD_BITS,
                                       .samples = 1};
}

/* Shadow, reflect, ... and the number of lights. */
static int effects(const sphaera_build_options *from, struct sph_build_options *to,
                   struct sph_error *err) {
#define TAKE(NAME, word, core, bit, most, all, option, ...) TAKE_##option(word, most)
#define TAKE_SPH_OPTION_WHEN(word, most)                                                           \
    to->word = from->word;                                                                         \
    if (from->word < SPHAERA_AUTO || from->word > SPHAERA_ON)                                      \
        return sph_fail(err, "%s is %d, not SPHAERA_AUTO, _OFF or _ON", #word, from->word);
#define TAKE_SPH_OPTION_OFF TAKE_SPH_OPTION_WHEN
#define TAKE_SPH_OPTION_COUNT(word, most)                                                          \
    to->word = from->word;                                                                         \
    if (sph_api_whole(#word, from->word, SPHAERA_AUTO, most, err)) return -1;
#define TAKE_SPH_OPTION_NONE(word, most)
    SPH_EACH_EFFECT(TAKE)
    return 0;
}

static int sizes(const sphaera_build_options *from, struct sph_api_build *to,
                 struct sph_error *err) {
    struct sph_build_options *o = &to->o;
    if (from->width < 0 || from->height < 0 || from->width > SPH_MAX_SIDE ||
        from->height > SPH_MAX_SIDE)
        return sph_fail(err, "size is %dx%d, sides are 1 to %d, or 0", from->width, from->height,
                        SPH_MAX_SIDE);
    if (sph_api_whole("depth", from->depth, 0, SPH_MAX_DEPTH, err) ||
        sph_api_whole("samples", from->samples, 1, MOST_SAMPLES, err) ||
        sph_api_real("least_weight", from->least_weight, 0, 1, err))
        return -1;
    o->width = from->width;
    o->height = from->height;
    o->max_depth = from->depth;
    o->least_weight = (int)(SPH_LEAST_WEIGHT_MAX * from->least_weight);
    to->samples = from->samples;
    return 0;
}

/* What rays go through. */
static int accel(const sphaera_build_options *from, struct sph_build_options *o,
                 struct sph_error *err) {
    static const char *const accels[] = {"auto", "bvh4", "bih", "brute", "box4", NULL};
    static const int kinds[] = {SPH_TREE_AUTO, 0, SPH_TREE_BIH, SPH_TREE_BRUTE, SPH_TREE_BOX4};
    static const char *const ways[] = {"full", "listing", NULL};
    static const char *const axes[] = {"auto", "camera", "scene", NULL};
    enum { AUTO, BVH4, BIH };
    int a = sph_api_choice("accel", from->accel, accels, err);
    int t = sph_api_choice("tree", from->tree, sph_build_trees, err);
    int b = sph_api_choice("bih", from->bih, ways, err);
    int x = sph_api_choice("axes", from->axes, axes, err);
    if (a < 0 || t < 0 || b < 0 || x < 0) return -1;
    sph_build_set_tree(o, t);
    if (a == AUTO && o->tree != SPH_TREE_REINSERTED) a = BVH4;
    if (a != BVH4 && o->tree != SPH_TREE_REINSERTED)
        return sph_fail(err, "tree is '%s', which is for accel 'bvh4', not '%s'", from->tree,
                        accels[a]);
    const char *only = b                      ? "bih"
                       : from->max_prims      ? "max_prims"
                       : from->max_tree_depth ? "max_tree_depth"
                       : from->bih_fit != 0   ? "bih_fit"
                                              : NULL;
    if (only && a != BIH) return sph_fail(err, "%s is for accel 'bih', not '%s'", only, accels[a]);
    if (from->max_tree_depth != SPHAERA_INFINITY &&
        sph_api_whole("max_tree_depth", from->max_tree_depth, 0, LEVELS_MOST, err))
        return -1;
    if (from->bih_fit != 0 && from->bih_fit != INFINITY &&
        sph_api_real("bih_fit", from->bih_fit, 1, 100, err))
        return -1;
    o->bih_fit = from->bih_fit == INFINITY ? UINT32_MAX : (uint32_t)lround(100 * from->bih_fit);
    if (a != BVH4) o->tree = kinds[a];
    o->bih = SPH_BIH_FULL + b;
    o->axes = SPH_AXES_AUTO + x;
    o->max_prims = from->max_prims;
    o->max_tree_depth = from->max_tree_depth == SPHAERA_INFINITY ? 0 : from->max_tree_depth;
    return 0;
}

static int background(const sphaera_build_options *from, struct sph_build_options *o,
                      struct sph_error *err) {
    static const char *const names[] = {"none", "rect", "spans", "exact", NULL};
    int b = sph_api_choice("background", from->background, names, err);
    if (b < 0) return -1;
    if (from->bg_points &&
        sph_api_whole("bg_points", from->bg_points, SPH_POINTS_MIN, SPH_POINTS_MAX, err))
        return -1;
    if (sph_api_whole("bg_border", from->bg_border, 0, SPH_BORDER_MAX, err) ||
        sph_api_whole("bg_levels", from->bg_levels, 0, SPH_BG_LEVELS, err))
        return -1;
    o->background = SPH_BG_NONE + b;
    const char *only = from->bg_points                   ? "bg_points"
                       : from->bg_border != o->bg_border ? "bg_border"
                                                         : NULL;
    if (only && o->background != SPH_BG_SPANS)
        return sph_fail(err, "%s is for background 'spans', not '%s'", only, names[b]);
    if (from->bg_levels && o->background != SPH_BG_EXACT)
        return sph_fail(err, "bg_levels is for background 'exact', not '%s'", names[b]);
    o->bg_points = from->bg_points;
    o->bg_border = from->bg_border;
    o->bg_levels = from->bg_levels;
    return 0;
}

/* Texels, and how a ray ends. */
static int words(const sphaera_build_options *from, struct sph_api_build *to,
                 struct sph_error *err) {
    static const char *const filters[] = {"nearest", "bilinear", "level", "between", NULL};
    static const char *const lods[] = {"mended", "paper", NULL};
    static const char *const hows[] = {"nearest", "first", NULL};
    static const char *const whiches[] = {"all", "met", NULL};
    int filter = sph_api_choice("filter", from->filter, filters, err);
    int lod = sph_api_choice("lod", from->lod, lods, err);
    int how = sph_api_choice("traverse", from->traverse, hows, err);
    to->met = sph_api_choice("effects", from->effects, whiches, err);
    if (filter < 0 || lod < 0 || how < 0 || to->met < 0 ||
        sph_api_whole("lod_bits", from->lod_bits, 0, SPH_LOD_BITS, err))
        return -1;
    to->o.tex_filter = SPH_FILTER_NEAREST + filter;
    to->o.lod_literal = lod;
    to->o.traverse = SPH_BUILD_NEAREST + how;
    to->o.coarse = SPH_LOD_BITS - from->lod_bits;
    return 0;
}

static int profile(const sphaera_build_options *from, struct sph_api_build *to,
                   struct sph_error *err) {
    to->bound = (struct sph_error_bound){
        from->error_pixels != 0 ? from->error_pixels : SPH_ERROR_BOUND_PIXELS,
        from->error_psnr != 0 ? from->error_psnr : SPH_ERROR_BOUND_PSNR};
    if (sph_api_real("error_pixels", to->bound.pixels, 1e-9, 1e9, err) ||
        sph_api_real("error_psnr", to->bound.psnr, 0, 99, err))
        return -1;
    if (!strcmp(from->profile, "auto")) return 0;
    to->o.widths = &to->widths;
    return sph_profile_parse(from->profile, &to->widths, err);
}

/* Where the camera looks from, and which part of the picture it draws. */
static int aim(const sphaera_build_options *from, struct sph_aim *to, struct sph_error *err) {
    const int *wall = from->wall;
    *to = (struct sph_aim){.shifted = from->shifted,
                           .shift = {from->shift[0], from->shift[1]},
                           .eye = {from->eye[0], from->eye[1], from->eye[2]},
                           .wall = {wall[0], wall[1], wall[2], wall[3]}};
    if (sph_api_whole("shifted", from->shifted, 0, 1, err)) return -1;
    for (int i = 0; i < 2; i++)
        if (sph_api_real("shift", from->shift[i], -SPH_SHIFT_MAX, SPH_SHIFT_MAX, err)) return -1;
    for (int i = 0; i < 3; i++)
        if (sph_api_real("eye", from->eye[i], -SPH_NUMBER_MAX, SPH_NUMBER_MAX, err)) return -1;
    for (int i = 0; i < 2; i++) {
        int none = !wall[0] && !wall[1];
        if (sph_api_whole("wall", wall[i], none ? 0 : 1, SPH_MAX_SIDE, err) ||
            sph_api_whole("wall", wall[2 + i], 0, none ? 0 : wall[i] - 1, err))
            return -1;
    }
    return 0;
}

/* What a tree that is kept excludes. */
static int refit(const sphaera_build_options *from, struct sph_api_build *to,
                 struct sph_error *err) {
    to->refit = from->refit;
    if (sph_api_whole("refit", from->refit, 0, 1, err)) return -1;
    if (!from->refit) return 0;
    if (to->o.tree == SPH_TREE_PAPER || to->o.tree == SPH_TREE_HW)
        return sph_fail(err, "refit: a tree '%s' cannot be refitted", from->tree);
    if (to->o.traverse != SPH_BUILD_NEAREST)
        return sph_fail(err, "refit: with traverse '%s' every frame has a tree of its own",
                        from->traverse);
    if (to->met) return sph_fail(err, "refit: effects 'met' are those of one frame alone");
    return 0;
}

int sph_api_options(const sphaera_build_options *from, struct sph_api_build *to,
                    struct sph_error *err) {
    sphaera_build_options defaults;
    sphaera_build_init(&defaults);
    if (!from) from = &defaults;
    *to = (struct sph_api_build){.o = SPH_BUILD_DEFAULT};
    if (from->size != sizeof *from)
        return sph_fail(err, "build options: not those of sphaera_build_init()");
    if (!from->profile) return sph_fail(err, "profile is NULL");
    if (accel(from, &to->o, err) || sizes(from, to, err) || effects(from, &to->o, err) ||
        background(from, &to->o, err) || words(from, to, err) || profile(from, to, err) ||
        aim(from, &to->aim, err))
        return -1;
    const char *why = sph_build_contradiction(&to->o);
    if (why) return sph_fail(err, "%s", why);
    if (refit(from, to, err)) return -1;
    sph_api_tell(from->progress, from->user, to);
    return 0;
}

void sph_api_tell(sphaera_progress progress, void *user, struct sph_api_build *to) {
    to->told = (struct sph_api_told){progress, user, 0};
    to->progress = (struct sph_progress){sph_api_show, &to->told, 0, 1};
    to->o.progress = progress ? &to->progress : NULL;
}

int sph_api_frame(const struct sph_scene *scene, struct sph_api_build *b, struct sph_scene *to,
                  struct sph_error *err) {
    *to = *scene;
    if (sph_camera_aim(&b->aim, &to->camera, scene->path, err)) return -1;
    int width = b->o.width ? b->o.width : scene->camera.width;
    int height = b->o.height ? b->o.height : scene->camera.height, n = b->samples;
    if (n == 1) return 0;
    if (width > SPH_MAX_SIDE / n || height > SPH_MAX_SIDE / n)
        return sph_fail(err, "samples is %d: %d times %dx%d pixels, sides of a frame are 1 to %d",
                        n, n, width, height, SPH_MAX_SIDE);
    b->o.width = n * width;
    b->o.height = n * height;
    return 0;
}
