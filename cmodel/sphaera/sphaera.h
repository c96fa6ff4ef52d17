/* sphaera.h - the library: scenes, machines, the golden model that draws them
 * SPDX-License-Identifier: Apache-2.0
 *
 * A scene is what a user wrote, in real numbers. A machine is all that the hardware sees: build
 * makes it of a scene. A frame is what the golden model draws of a machine, bit by bit what the
 * hardware gives: colours, ids, keys, visits, counters.
 *
 * Errors. A function that can fail returns 0, or -1 with a message in *error, which names file,
 * line and field and may be NULL. It refuses any other argument that is NULL, if its comment does
 * not say what NULL means; functions that cannot fail must not be given NULL. After -1 nothing was
 * made and there is nothing to free. Nothing here ends the program, prints, or changes the locale.
 *
 * Threads. There is no global state. A scene, a machine and a frame never change once they are
 * made: any number of threads may use the same one at once, until one of them frees it. What is
 * made of a machine keeps it, so that it may be freed before. sphaera_build(), from 1000 primitives
 * on, and sphaera_render() share work with threads of their own, which wait without turning, take
 * no signals and are gone when the call returns; so a process may fork between calls, and the child
 * may call.
 *
 * Floating point. The caller's rounding, traps and flags change no result, and are his again when a
 * call returns.
 */
#ifndef SPHAERA_SPHAERA_H
#define SPHAERA_SPHAERA_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SPHAERA_API __attribute__((visibility("default")))

typedef struct sphaera_scene sphaera_scene;
typedef struct sphaera_machine sphaera_machine;
typedef struct sphaera_frame sphaera_frame;

typedef struct sphaera_error {
    char text[512]; /* empty: no error */
} sphaera_error;

/* How far a call is, `done` of `all`, told by one thread at a time, which may be another one than
 * the caller's and must call nothing here. What it returns, if not 0, cancels the call, which then
 * ends soon, with -1 and the message "cancelled". */
typedef int (*sphaera_progress)(void *user, int done, int all);

/* Version of the library, such as "1.2.3". */
SPHAERA_API const char *sphaera_version(void);

/* ---- scenes (docs/reference/scene_format.md) ---- */

/* Reads a scene file; at: frame that moving primitives are moved to, 0..65535. If there is no file
 * of this name, it may be KIND or KIND:N of `sphaera gen`, such as "random:256", which is made. */
SPHAERA_API int sphaera_scene_read(const char *path, uint32_t at, sphaera_scene **scene,
                                   sphaera_error *error);

/* The same of a text of NFF in memory, of `length` bytes. name stands in messages and in the
 * machine; its folder is where images are looked for. */
SPHAERA_API int sphaera_scene_parse(const char *text, size_t length, const char *name, uint32_t at,
                                    sphaera_scene **scene, sphaera_error *error);

/* How a file is read. sphaera_read_init() sets the defaults, those of the tool; a struct that it
 * did not set is refused, as is one of another *_init() below. */
typedef struct sphaera_read_options {
    size_t size;
    uint32_t at; /* frame that moving primitives are moved to, 0..65535 */
    int timed;   /* AFF: 1: at `time`, -1e9..1e9, whatever the frame */
    double time;
    double round;         /* cones: greatest distance over the larger radius, 1e-6..0.5; 0: 0.005 */
    const char *camera;   /* of a mesh: its name or number; NULL: the first */
    double radius;        /* of points without one, 1e-9..1e9; 0: as --radius */
    char up;              /* of a mesh: 'x', 'y', 'z'; 0: as its format has it */
    int skip_unsupported; /* 1: leave out patches instead of refusing the scene */
    int strict;           /* 1: what is not used as it stands is an error, with file and line */
    int allow_paths;      /* 1: files that the scene names may lie anywhere; 0: in its folder and
                             below, of AFF in TextureFiles beside it too */
    sphaera_progress progress; /* NULL: nobody is told */
    void *user;
} sphaera_read_options;
SPHAERA_API void sphaera_read_init(sphaera_read_options *options);

/* sphaera_scene_read() and sphaera_scene_parse() with all options; NULL: the defaults. */
SPHAERA_API int sphaera_scene_read_with(const char *path, const sphaera_read_options *options,
                                        sphaera_scene **scene, sphaera_error *error);
SPHAERA_API int sphaera_scene_parse_with(const char *text, size_t length, const char *name,
                                         const sphaera_read_options *options, sphaera_scene **scene,
                                         sphaera_error *error);

/* A scene in arrays of the caller, which are copied. Numbers are finite, of at most 1e30, colours
 * and shares 0..1, material numbers rows of `materials`. Ids are rows of the spheres, then of the
 * triangles, then of the planes, less those that sphaera_scene_record() counts as left out: of its
 * records the file is `name`, the line the row of the array, from 1 on. */
typedef struct sphaera_arrays {
    size_t size;
    const char *name;             /* in messages and in the machine: "arrays" */
    double from[3], at[3], up[3]; /* camera: eye, what it looks at, upwards */
    double angle;                 /* vertical field of view, degrees, within 0..180 */
    double shift[2];              /* of the picture's middle to the right and up, in its heights,
                                     -64..64 */
    int width, height;            /* pixels, 1..16383 */
    double background[3], ambient[3]; /* colours */
    uint32_t n_materials, n_spheres, n_triangles, n_planes, n_lights;
    const double *materials; /* [n][8]: red green blue Kd Ks Shine T index, `f` of NFF */
    const double *spheres;   /* [n][4]: centre, radius; below 0: inner surface of hollow glass */
    const uint32_t *sphere_materials;   /* [n]; NULL: 0, as below */
    const double *triangles;            /* [n][3][3]: corners */
    const double *normals;              /* [n][3][3] of corners, any length; NULL: they are flat */
    const uint32_t *triangle_materials; /* [n] */
    const double *planes;               /* [n][6]: a point, the normal */
    const uint32_t *plane_materials;    /* [n] */
    const double *lights;               /* [n][3]: where; at most 8 */
    const double *light_colours;        /* [n][3], 0 or more; NULL: 1 / sqrt(n) */
    uint32_t n_textures;
    const char *const *textures;       /* [n]: files of images, which repeat */
    const uint32_t *sphere_textures;   /* [n]: rows of textures, SPHAERA_NONE: none; NULL: none */
    const uint32_t *triangle_textures; /* [n] likewise */
    const double *st;                  /* [n][3][2]: s, t of the triangles' corners, 0..1 across
                                          the image and up; of those with a texture */
} sphaera_arrays;

/* No primitives, one white material, a camera at (0, 0, 1) that looks at 0, 320x180 pixels. */
SPHAERA_API void sphaera_arrays_init(sphaera_arrays *arrays);

/* Makes the scene. -1: a message that names array, row and field, such as
 * "spheres[3]: radius is 0". */
SPHAERA_API int sphaera_scene_make(const sphaera_arrays *arrays, sphaera_scene **scene,
                                   sphaera_error *error);

/* Writes a scene as NFF, whole or not at all; every double survives. */
SPHAERA_API int sphaera_scene_write(const sphaera_scene *scene, const char *path,
                                    sphaera_error *error);

/* A scene that may be NULL, as of free(). */
SPHAERA_API void sphaera_scene_free(sphaera_scene *scene);

SPHAERA_API uint32_t sphaera_scene_spheres(const sphaera_scene *scene);
SPHAERA_API uint32_t sphaera_scene_facets(const sphaera_scene *scene); /* triangles and planes */

/* What became of each record of the file: a row for each kind that there is. */
typedef struct sphaera_record {
    const char *kind; /* such as "sphere", or "triangle or polygon without area" */
    const char *end;  /* "used", "used otherwise", "left out" */
    const char *file; /* of the first one; stands as long as what it was asked of */
    uint32_t line;    /* of the first one, 0: none */
    uint64_t count;
} sphaera_record;

/* Row 0, 1, ... of a scene; -1 behind the last, and then nothing is written. */
SPHAERA_API int sphaera_scene_record(const sphaera_scene *scene, int number,
                                     sphaera_record *record);

/* ---- machines ---- */

/* What is built. sphaera_build_init() sets the defaults of the tool; words and numbers are those of
 * `sphaera build --help`. Switches are SPHAERA_AUTO, as the scene calls for, _OFF or _ON. */
typedef struct sphaera_build_options {
    size_t size;
    const char *profile; /* "auto", "draft", "standard", ..., with widths: "draft:w=14" */
    const char *accel;   /* "auto", "bvh4", "bih", "brute", "box4" */
    int width, height;   /* pixels; 0: as the scene says */
    int depth;           /* reflections and refractions one after another, 0..10 */
    int shadow, reflect, refract, specular, texture;
    int clear, inside, interpenetrate, smooth, spread;
    int lights;          /* the first 0..8; SPHAERA_AUTO: those that reach something */
    const char *effects; /* "all" that the scene names, or "met": those that rays of this frame
                            meet, which is drawn to find out, as `sphaera build` does by itself;
                            such a machine is for its own camera alone */
    double
        error_pixels;   /* "auto" keeps: what the eye sees is off by at most, 1e-9..1e9; 0: 0.125 */
    double error_psnr;  /* and dB of the picture, up to 99; 0: 45 */
    const char *tree;   /* of bvh4: "reinserted", "balanced", "paper", "paper-grown", "hw", "hw1",
                           "hw2" */
    const char *axes;   /* of the grid: "auto", "camera", "scene" */
    const char *bih;    /* "full", "listing" */
    uint32_t max_prims; /* bih: a leaf of no more is not cut; 0: 4; SPHAERA_INFINITY */
    uint32_t max_tree_depth;   /* bih: levels, 1..65; 0: 65 */
    double bih_fit;            /* bih: as --bih-fit, 1..100, INFINITY; 0: its default */
    const char *background;    /* "none", "rect", "spans", "exact" */
    int bg_points;             /* spans: meridians and parallels, 4..4096; 0: 16 */
    int bg_border;             /* spans: pixels around the outline, 0..64 */
    int bg_levels;             /* exact: 0 the root sphere, 1 its children, 2 theirs */
    const char *traverse;      /* of primary rays: "nearest", "first" */
    const char *filter;        /* of texels: "between", "level", "bilinear", "nearest" */
    const char *lod;           /* "mended", "paper" */
    int lod_bits;              /* of the fraction of a level, 0..8 */
    double least_weight;       /* rays of less than this share of a pixel end, 0..1 */
    int samples;               /* N x N rays a pixel, 1..16: the frame has N times the sides, and
                                  pictures of it the mean of its light */
    int shifted;               /* 1: `shift` takes the place of the scene's, as --shift */
    double shift[2];           /* of the picture's middle to the right and up, in its heights */
    double eye[3];             /* the eye moves to the right, up and back, as --eye-shift */
    int wall[4];               /* columns, rows; column, row of this frame, as --wall; 0, 0: none */
    int refit;                 /* 1: the machine keeps its tree for sphaera_refit(); with neither
                                  tree "paper", "paper-grown" or "hw", traverse "first" nor
                                  effects "met" */
    sphaera_progress progress; /* NULL: nobody is told */
    void *user;
} sphaera_build_options;
enum { SPHAERA_AUTO = -1, SPHAERA_OFF = 0, SPHAERA_ON = 1 };
#define SPHAERA_INFINITY 0xffffffffu

SPHAERA_API void sphaera_build_init(sphaera_build_options *options);

/* Builds the machine; options NULL: the defaults. Reads the scene's images. */
SPHAERA_API int sphaera_build(const sphaera_scene *scene, const sphaera_build_options *options,
                              sphaera_machine **machine, sphaera_error *error);

/* A machine of `scene` with the tree of `machine`, which was built with `refit`, or refitted, and
 * does not change: nodes keep their children and get new bounds, as `sphaera build --frames --refit
 * on` makes them (docs/design/builder.md). All else is built by the same options, in the profile,
 * tree and size that they led to. Pixels, ids and keys are those of a tree built anew, visits are
 * not. progress NULL: nobody is told. -1: it keeps no tree, or the scene has other primitives: so
 * many spheres, triangles and planes as the first, in their order, less those that the grid leaves
 * out. */
SPHAERA_API int sphaera_refit(const sphaera_scene *scene, const sphaera_machine *machine,
                              sphaera_progress progress, void *user, sphaera_machine **moved,
                              sphaera_error *error);

/* Of a tree that was refitted: the visits expected of a ray, over those of the tree when it was
 * built, which tells when to build anew: --refit auto does so above 1.1. 1 of any other. */
SPHAERA_API double sphaera_machine_tree_cost(const sphaera_machine *machine);

/* Reads and checks a machine file; writes one, whole or not at all. */
SPHAERA_API int sphaera_machine_read(const char *path, sphaera_machine **machine,
                                     sphaera_error *error);
SPHAERA_API int sphaera_machine_write(const sphaera_machine *machine, const char *path,
                                      sphaera_error *error);
SPHAERA_API void sphaera_machine_free(sphaera_machine *machine);

SPHAERA_API int sphaera_machine_width(const sphaera_machine *machine);
SPHAERA_API int sphaera_machine_height(const sphaera_machine *machine);
SPHAERA_API const char *sphaera_machine_profile(const sphaera_machine *machine);

/* What build warned of, lines of text; empty if nothing, or if it was read from a file. */
SPHAERA_API const char *sphaera_machine_warning(const sphaera_machine *machine);

/* Why "auto" took its profile, and what is known of the picture: "standard: measured 47.0 dB of
 * 57600 pixels, ..."; empty if a profile was asked for, or if it was read from a file. */
SPHAERA_API const char *sphaera_machine_why(const sphaera_machine *machine);

/* The same of a machine: its scene's, and what the grid left out or limited; or what its file has,
 * if it was read from one. */
SPHAERA_API int sphaera_machine_record(const sphaera_machine *machine, int number,
                                       sphaera_record *record);

/* ---- what the hardware sees of a machine ---- */

/* Registers by number: their names, such as "EFFECTS" and "LIGHT3_X", NULL where there is none;
 * how many numbers there are; their words. */
SPHAERA_API int sphaera_registers(void);
SPHAERA_API const char *sphaera_register_name(int number);
SPHAERA_API const int32_t *sphaera_machine_registers(const sphaera_machine *machine);

/* Memory: *lines times 256 bits, 8 words each, low bits first; in the machine, as the registers. */
SPHAERA_API const uint32_t *sphaera_machine_memory(const sphaera_machine *machine, uint32_t *lines);

/* One of them: a register, 0 if there is none of this number; the words of a line, -1 if there is
 * none, and then nothing is written. */
SPHAERA_API int32_t sphaera_machine_register(const sphaera_machine *machine, int number);
SPHAERA_API int sphaera_machine_line(const sphaera_machine *machine, uint32_t line,
                                     uint32_t words[8]);

/* Parameters of rt_core that draws it, by name: widths, and the least of each effect. Number 0, 1,
 * ...; -1 behind the last, and then nothing is written. */
typedef struct sphaera_parameter {
    const char *name; /* such as "WD" or "REFLECT"; stands for ever */
    int value;
} sphaera_parameter;
SPHAERA_API int sphaera_machine_parameter(const sphaera_machine *machine, int number,
                                          sphaera_parameter *parameter);

/* The same of effects in words of sim/cores.py: "shadow+reflect2+lights1"; "none". */
SPHAERA_API const char *sphaera_machine_core(const sphaera_machine *machine);

/* A machine of registers and memory, which are copied and checked; n_registers is
 * sphaera_registers(). Its grid is not known: points are in grid units. */
SPHAERA_API int sphaera_machine_make(const int32_t *registers, int n_registers,
                                     const uint32_t *memory, uint32_t lines, const char *name,
                                     sphaera_machine **machine, sphaera_error *error);

/* Writes what `sphaera export` does: "hex": path.regs.hex and path.mem.hex for $readmemh; "c":
 * path, arrays of C. */
SPHAERA_API int sphaera_machine_export(const sphaera_machine *machine, const char *format,
                                       const char *path, sphaera_error *error);

/* ---- frames ---- */

/* How a frame is drawn. sphaera_render_init() sets the defaults of the tool. */
typedef struct sphaera_render_options {
    size_t size;
    int threads;               /* 0: one for every processor */
    const char *traverse;      /* "fast"; "literal": the text beside the RTL; "brute": no tree;
                                  "packets": faster, without visits and counters of the tree */
    sphaera_progress progress; /* of rows; NULL: nobody is told */
    void *user;
    const int *stop; /* NULL; or what another thread or a handler of signals makes other than 0:
                        that cancels the call too, within the time of some pixels */
} sphaera_render_options;
SPHAERA_API void sphaera_render_init(sphaera_render_options *options);
SPHAERA_API int sphaera_render_with(const sphaera_machine *machine,
                                    const sphaera_render_options *options, sphaera_frame **frame,
                                    sphaera_error *error);

/* Draws the machine. threads: 0: one for every processor. */
SPHAERA_API int sphaera_render(const sphaera_machine *machine, int threads, sphaera_frame **frame,
                               sphaera_error *error);
SPHAERA_API void sphaera_frame_free(sphaera_frame *frame);

SPHAERA_API int sphaera_frame_width(const sphaera_frame *frame);
SPHAERA_API int sphaera_frame_height(const sphaera_frame *frame);

/* Each fills an array of the caller with width * height pixels, row by row from the top.
 *   rgb     3 bytes a pixel, red, green, blue, linear light; layer: 0 without reflections, 1 with
 *           one, 2 all. -1 for another layer, and then nothing is written
 *   id      primitive that the primary ray hit, in the scene's order; SPHAERA_NONE: none
 *   key     of that hit, orders hits on one ray; 0: none
 *   visits  tree nodes that all rays of the pixel visited */
SPHAERA_API int sphaera_frame_rgb(const sphaera_frame *frame, int layer, uint8_t *rgb);
SPHAERA_API void sphaera_frame_id(const sphaera_frame *frame, uint32_t *id);
SPHAERA_API void sphaera_frame_key(const sphaera_frame *frame, uint64_t *key);
SPHAERA_API void sphaera_frame_visits(const sphaera_frame *frame, uint32_t *visits);
#define SPHAERA_NONE 0xffffffu

/* Layers, likewise, of the primary hit; any array may be NULL. -1 if memory is out.
 *   texture   {lod u4.8 of the first texture, 4095: none; sum of texel addresses u20}, as hardware
 *   level     float; of the image that is seen first, 0: whole size; -1: none
 *   normal    3 floats a pixel, of length 1, in the scene's frame, towards the eye; 0: no hit
 *   depth     float; along the view, in units of the scene; infinite: no hit
 *   distance  float; the same from the eye
 *   albedo    3 floats a pixel; of the material, 0..1, without its image */
typedef struct sphaera_layers {
    uint32_t *texture;
    float *level, *normal, *depth, *distance, *albedo;
} sphaera_layers;
SPHAERA_API int sphaera_frame_layers(const sphaera_frame *frame, const sphaera_layers *to,
                                     sphaera_error *error);

/* Hash of all that `sphaera render` prints one of: equal frames have equal hashes. */
SPHAERA_API uint64_t sphaera_frame_hash(const sphaera_frame *frame);

/* Sticky errors of the drawing, a bit each (docs/reference/core.md); 0: none. */
SPHAERA_API uint32_t sphaera_frame_errors(const sphaera_frame *frame);

/* Writes a picture in the format of the name's ending: 8 bits in sRGB, or OpenEXR, linear, with all
 * layers. */
SPHAERA_API int sphaera_frame_write(const sphaera_frame *frame, const char *path,
                                    sphaera_error *error);

/* The same with the tool's options; sphaera_picture_init() sets its defaults. */
typedef struct sphaera_picture_options {
    size_t size;
    int layer;            /* 0 without reflections, 1 with one, 2 all */
    const char *transfer; /* "srgb", "linear" */
    int depths;           /* 1: colours tell how many surfaces one behind another made a pixel */
    int samples;          /* a pixel is the mean of N x N; 0: those of build */
} sphaera_picture_options;
SPHAERA_API void sphaera_picture_init(sphaera_picture_options *options);
SPHAERA_API int sphaera_frame_write_with(const sphaera_frame *frame, const char *path,
                                         const sphaera_picture_options *options,
                                         sphaera_error *error);

/* A frame as bytes, all of it but its machine, for another process of the same version on the same
 * kind of computer: how many, and they themselves, into an array of the caller; and a frame of
 * them, of the machine that it was drawn of: -1 if they are no such bytes, or damaged. */
SPHAERA_API size_t sphaera_frame_size(const sphaera_frame *frame);
SPHAERA_API void sphaera_frame_pack(const sphaera_frame *frame, uint8_t *bytes);
SPHAERA_API int sphaera_frame_unpack(const sphaera_machine *machine, const uint8_t *bytes,
                                     size_t size, sphaera_frame **frame, sphaera_error *error);

/* Counters, by number or by name such as "node_visits" (docs/reference/core.md): their names, NULL
 * behind the last; their values, 0 where the hardware alone counts; -1 if the name is none; 1 if
 * hardware must count the same. */
SPHAERA_API const char *sphaera_counter_name(int number);
SPHAERA_API uint64_t sphaera_frame_counter(const sphaera_frame *frame, int number);
SPHAERA_API int sphaera_counter_find(const char *name);
SPHAERA_API int sphaera_counter_exact(int number);

/* ---- one ray ---- */

typedef struct sphaera_hit {
    uint32_t id;     /* primitive, SPHAERA_NONE: nothing was hit, and the rest is 0 */
    int inside;      /* its far side was hit, from inside */
    uint64_t key;    /* ceil(a t), exact */
    double distance; /* from the origin, in units of the scene */
    double point[3]; /* there, in the frame of the origin */
    uint32_t visits; /* tree nodes visited */
} sphaera_hit;

/* The nearest primitive on a ray, as hardware with effect `inside` finds it: the origin is rounded
 * to the machine's grid, the direction to its width. Both are in the scene's frame. -1 if the
 * origin lies outside the grid, or the direction is zero or not finite. */
SPHAERA_API int sphaera_trace(const sphaera_machine *machine, const double origin[3],
                              const double direction[3], sphaera_hit *hit, sphaera_error *error);

/* ---- many rays ---- */

/* Where what n rays hit goes: arrays [n] of the caller, NULL: not asked for. */
typedef struct sphaera_hits {
    uint32_t *id; /* SPHAERA_NONE: nothing was hit, and the rest but visits is 0 */
    uint64_t *key;
    uint8_t *inside; /* 1: the far side was hit, from inside */
    uint32_t *visits;
    double *distance; /* units of the scene */
} sphaera_hits;

/* sphaera_trace() of n rays, origins and directions [n][3] in the scene's frame, shared by threads,
 * 0: one for every processor. -1: a message that names the first ray it cannot take, such as
 * "origins[7] lies outside the grid"; the arrays then hold anything. */
SPHAERA_API int sphaera_trace_rays(const sphaera_machine *machine, size_t n, const double *origins,
                                   const double *directions, int threads, const sphaera_hits *hits,
                                   sphaera_error *error);

/* The same of integers, as hardware has them: origins in grid units of W bits, directions of WD,
 * along the grid's axes. Primary rays of a frame are found by sphaera_primary(), and then id, key
 * and visits are those of a core that draws no other rays. */
SPHAERA_API int sphaera_trace_grid(const sphaera_machine *machine, size_t n, const int32_t *origins,
                                   const int32_t *directions, int threads, const sphaera_hits *hits,
                                   sphaera_error *error);

/* The primary ray of a pixel in integers. -1 if it lies outside the frame. */
SPHAERA_API int sphaera_primary(const sphaera_machine *machine, int x, int y, int32_t origin[3],
                                int32_t direction[3], sphaera_error *error);

/* ---- the rays of one pixel, stage by stage (`sphaera info --pixel X,Y --stages`) ---- */

typedef struct sphaera_pixel sphaera_pixel;

SPHAERA_API int sphaera_pixel_trace(const sphaera_machine *machine, int x, int y,
                                    sphaera_pixel **pixel, sphaera_error *error);
SPHAERA_API void sphaera_pixel_free(sphaera_pixel *pixel); /* may be NULL */

/* Rays in the order in which they are traced. Row 0, 1, ...; -1 behind the last. */
typedef struct sphaera_ray {
    const char *kind;                /* "primary", "shadow", "reflected", "refracted" */
    int parent;                      /* number of the ray at whose hit it starts; -1: the eye */
    int depth;                       /* reflections and refractions before it */
    int64_t origin[3], direction[3]; /* grid units; direction units */
    int hit; /* 1: something; of a shadow ray: the light is hidden, and the rest is 0 */
    int inside;
    uint32_t id, visits;
    uint64_t key;
} sphaera_ray;
SPHAERA_API int sphaera_pixel_ray(const sphaera_pixel *pixel, int number, sphaera_ray *ray);

/* Stages of these rays, ray by ray, as model and RTL have them alike. */
typedef struct sphaera_stage {
    const char *name; /* "set-up", "filter", "root", ... */
    int ray;          /* its number; -1: of the pixel */
    uint32_t visit;   /* of a tree node, from 1; 0: none */
    uint32_t number;  /* of child, primitive, texel or light */
    int operands;
} sphaera_stage;
SPHAERA_API int sphaera_pixel_stage(const sphaera_pixel *pixel, int number, sphaera_stage *stage);

/* An operand of a stage, 0 .. operands - 1; a vector is three of one name. */
typedef struct sphaera_operand {
    const char *name;
    int bits, is_signed;
    uint64_t low, high; /* of the word, `bits` of them */
    double value;       /* what it stands for; lengths in units of the scene */
} sphaera_operand;
SPHAERA_API int sphaera_pixel_operand(const sphaera_pixel *pixel, int stage, int number,
                                      sphaera_operand *operand);

/* The line that `sphaera info` prints of a stage; stands until the next call of this pixel, and of
 * one thread at a time; NULL behind the last. */
SPHAERA_API const char *sphaera_pixel_text(sphaera_pixel *pixel, int stage);

/* ---- verification of hardware: a frame of another core against the model's ---- */

/* What a core gives is told as it comes, in any order, by one thread at a time; whoever tells gets
 * 0 if the model has the same, 1 if not. The text then says where the first difference is, and has
 * the stages of all rays of its pixel. */
typedef struct sphaera_scoreboard sphaera_scoreboard;

/* Draws the machine with so many threads, 0: one for every processor. */
SPHAERA_API int sphaera_scoreboard_new(const sphaera_machine *machine, int threads,
                                       sphaera_scoreboard **board, sphaera_error *error);
SPHAERA_API void sphaera_scoreboard_free(sphaera_scoreboard *board); /* may be NULL */

/* A pixel of the pixel port: colours 0xBBGGRR. One outside the window, or that came before, is
 * a difference. The second takes the colour alone that register FRAME selects, as a frame in memory
 * has it. */
SPHAERA_API int sphaera_scoreboard_pixel(sphaera_scoreboard *board, int x, int y,
                                         uint32_t rendering, uint32_t l1, uint32_t l2, uint32_t id,
                                         uint64_t key, uint32_t visits, uint32_t texture);
SPHAERA_API int sphaera_scoreboard_colour(sphaera_scoreboard *board, int x, int y, uint32_t colour);

/* A counter, and the sticky errors, at the end of a frame; counters that the model has not are
 * never a difference. */
SPHAERA_API int sphaera_scoreboard_counter(sphaera_scoreboard *board, int number, uint64_t value);
SPHAERA_API int sphaera_scoreboard_errors(sphaera_scoreboard *board, uint32_t bits);

/* The end of a frame: pixels that did not come are a difference. Returns all of the frame and
 * expects the next one of the same machine; the text stays until that begins to differ. */
SPHAERA_API int sphaera_scoreboard_end(sphaera_scoreboard *board);

/* Lines of text on the first difference, empty: there is none; stands until the next call. */
SPHAERA_API const char *sphaera_scoreboard_text(const sphaera_scoreboard *board);

/* ---- single units of hardware: what each gives, bit for bit ---- */

/* -1 with a message that names an argument out of range; then nothing is written. Formats are those
 * of the RTL's ports. */

/* rt_unit: v of `bits` bits, 9..32, over its length: u s1.16, scale u1.16, shift. */
SPHAERA_API int sphaera_model_unit_vector(int bits, const int64_t v[3], int32_t u[3],
                                          uint32_t *scale, int *shift, sphaera_error *error);

/* rt_isqrt: floor of the root of high * 2^64 + low, high below 2^60; the `bits` most significant
 * bits of it, 0: all, with zeros behind them; inexact: its square is less. */
SPHAERA_API int sphaera_model_root(uint64_t high, uint64_t low, int bits, uint64_t *root,
                                   int *inexact, sphaera_error *error);

/* rt_quotient: key of key_bits over a of a_bits, both above 0: mant * 2^-exp, mant of pq bits. */
SPHAERA_API int sphaera_model_quotient(uint64_t key, int key_bits, uint64_t a, int a_bits, int pq,
                                       uint32_t *mant, int *exp, sphaera_error *error);

/* rt_leaf: the exact test of a sphere. */
typedef struct sphaera_leaf {
    int64_t origin[3], direction[3], centre[3], radius; /* of up to 24, 31, 24 and 24 bits */
    uint32_t id, skip_id;  /* of the sphere; of that on which the ray starts, SPHAERA_NONE: none */
    int skip_inside;       /* the ray starts inside that one */
    int shadow, inside_on; /* the ray ends at a light; rays may start inside spheres */
    int pr;                /* significant bits of the root, 0: all */
} sphaera_leaf;
typedef struct sphaera_leaf_result {
    int hit, far, exit;
    int64_t b;
    uint64_t disc_low, disc_high; /* 128 bits, two's complement; of a hit without exit */
    uint64_t key;                 /* of a hit; 0: none */
} sphaera_leaf_result;
SPHAERA_API int sphaera_model_leaf(const sphaera_leaf *leaf, sphaera_leaf_result *result,
                                   sphaera_error *error);

/* rt_filter: whether a child of a node may hold a hit, and the least depth that it reaches. */
typedef struct sphaera_filter {
    int32_t origin[3];  /* filter units */
    int least;          /* 0 x, 1 y, 2 z: the axis that p lies across */
    int32_t p_a, p_b;   /* s0.17 */
    int32_t q[3];       /* s0.17 */
    int axis, negative; /* the largest of |u|, and its sign */
    int32_t depth_max;  /* nothing deeper matters */
    int32_t centre[3], radius;
} sphaera_filter;
SPHAERA_API int sphaera_model_filter(const sphaera_filter *filter, int *pass, int32_t *near_depth,
                                     sphaera_error *error);

/* rt_texel_filter: four texels 0xBBGGRR of two levels, (x, y), (x+1, y), (x, y+1), (x+1, y+1), and
 * weights u0.8 of x+1, of y+1 and of the second level. */
SPHAERA_API int sphaera_model_texel(const uint32_t near_texels[4], const uint32_t far_texels[4],
                                    const int near_weights[2], const int far_weights[2], int level,
                                    uint32_t *texel, sphaera_error *error);

/* ---- what accuracy costs in time (`sphaera price`) ---- */

typedef struct sphaera_price sphaera_price;
typedef struct sphaera_price_row {
    const char *name;         /* "draft", ...; stands as long as the price does, as why */
    const char *why;          /* NULL; else nothing could be built, and the rest is 0 */
    double psnr, psnr_least;  /* dB measured against double precision, and of the whole frame at
                                 least; INFINITY: equal */
    double psnr_expected;     /* before anything is drawn, at least; 0: not known */
    uint64_t pixels;          /* that were looked at */
    uint64_t undecidable;     /* of them, that doubles cannot tell: they do not count */
    uint64_t wrong;           /* of them, that see another object */
    double wrong_most;        /* part of the whole frame's pixels that does, at most */
    int keeps;                /* what is asked for */
    double cycles_per_pixel;  /* of one engine, by the work of the model */
    int lut4eq, mult, bram;   /* cells of this very core on an ECP5; 0: nobody has made it */
    double mhz, milliseconds; /* its clock, routed, and a frame at it; 0: not known */
} sphaera_price_row;

/* Measures a row for each profile, or one if the options name it. options NULL: the defaults.
 * keep_pixels, keep_psnr: what a row is to keep, as of --error; 0, 0: its default. most: pixels of
 * a sample, 0: the whole frame. The options' progress is told of all, and may end it. */
SPHAERA_API int sphaera_price_measure(const sphaera_scene *scene,
                                      const sphaera_build_options *options, double keep_pixels,
                                      double keep_psnr, uint32_t most, sphaera_price **price,
                                      sphaera_error *error);
SPHAERA_API void sphaera_price_free(sphaera_price *price); /* may be NULL */

SPHAERA_API int sphaera_price_rows(const sphaera_price *price);

/* The first row that keeps what is asked for, the cheapest one; -1: none does. */
SPHAERA_API int sphaera_price_best(const sphaera_price *price);

/* Row 0 .. rows - 1 into *row; -1 for another, and then nothing is written. */
SPHAERA_API int sphaera_price_get(const sphaera_price *price, int number, sphaera_price_row *row);

#ifdef __cplusplus
}
#endif

#endif
