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
 * made: any number of threads may use the same one at once, until one of them frees it.
 * sphaera_build(), from 1000 primitives on, and sphaera_render() share work with threads of their
 * own, which wait without turning, take no signals and are gone when the call returns; so a process
 * may fork between calls, and the child may call.
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

/* From now on what is not used as it stands is an error, as with `--strict`: here, -1 for what has
 * been read, and in sphaera_build() for what the machine leaves out. To be called by the thread
 * that read the scene, before others use it. */
SPHAERA_API int sphaera_scene_strict(sphaera_scene *scene, sphaera_error *error);

/* ---- machines ---- */

/* What is built. sphaera_build_init() sets the defaults, those of `sphaera build`; words are those
 * of its options. A struct that it did not set is refused. */
typedef struct sphaera_build_options {
    size_t size;         /* of this struct, set by sphaera_build_init() */
    const char *profile; /* "auto", "draft", "standard", ...: widths of the arithmetic */
    const char *accel;   /* "auto", "bvh4", "bih", "brute", "box4" */
    int width, height;   /* pixels; 0: as the scene says */
    int depth;           /* reflections and refractions one after another, 0..10 */
    int shadow, reflect, refract, specular, texture; /* SPHAERA_AUTO, _OFF, _ON */
} sphaera_build_options;
enum { SPHAERA_AUTO = -1, SPHAERA_OFF = 0, SPHAERA_ON = 1 };

SPHAERA_API void sphaera_build_init(sphaera_build_options *options);

/* Builds the machine; options NULL: the defaults. Reads the scene's images. */
SPHAERA_API int sphaera_build(const sphaera_scene *scene, const sphaera_build_options *options,
                              sphaera_machine **machine, sphaera_error *error);

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

/* ---- frames ---- */

/* Draws the machine. threads: 0: one for every processor. */
SPHAERA_API int sphaera_render(const sphaera_machine *machine, int threads, sphaera_frame **frame,
                               sphaera_error *error);

/* The same, but -1 soon after *stop is not 0, which another thread or a handler of signals sets:
 * within the time of 64 pixels. stop may be NULL. */
SPHAERA_API int sphaera_render_until(const sphaera_machine *machine, int threads, const int *stop,
                                     sphaera_frame **frame, sphaera_error *error);
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

/* Hash of all that `sphaera render` prints one of: equal frames have equal hashes. */
SPHAERA_API uint64_t sphaera_frame_hash(const sphaera_frame *frame);

/* Sticky errors of the drawing, a bit each (docs/reference/core.md); 0: none. */
SPHAERA_API uint32_t sphaera_frame_errors(const sphaera_frame *frame);

/* Writes a picture in the format of the name's ending: 8 bits in sRGB, or OpenEXR, linear. */
SPHAERA_API int sphaera_frame_write(const sphaera_frame *frame, const char *path,
                                    sphaera_error *error);

/* A frame as bytes, all of it, for another process of the same machine and version: how many, and
 * they themselves, into an array of the caller; and a frame of them, -1 if they are no such bytes,
 * or damaged. */
SPHAERA_API size_t sphaera_frame_size(const sphaera_frame *frame);
SPHAERA_API void sphaera_frame_pack(const sphaera_frame *frame, uint8_t *bytes);
SPHAERA_API int sphaera_frame_unpack(const uint8_t *bytes, size_t size, sphaera_frame **frame,
                                     sphaera_error *error);

/* Counters, by number or by name such as "node_visits" (docs/reference/core.md): their names, NULL
 * behind the last; their values, 0 where the hardware alone counts; -1 if the name is none. */
SPHAERA_API const char *sphaera_counter_name(int number);
SPHAERA_API uint64_t sphaera_frame_counter(const sphaera_frame *frame, int number);
SPHAERA_API int sphaera_counter_find(const char *name);

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
 * a sample, 0: the whole frame. */
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
