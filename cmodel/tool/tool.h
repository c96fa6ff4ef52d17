/* tool.h - what the commands of the tool share
 * SPDX-License-Identifier: Apache-2.0
 *
 * A command gets its own argument vector and returns the exit code: 0, 1 if something failed or
 * differs, 2 on wrong usage. Messages go to stderr as `sphaera: ...`.
 */
#ifndef SPH_TOOL_H
#define SPH_TOOL_H

#include <argp.h>

#include "trial/choose.h"
#include "common/error.h"
#include "machine/machine.h"
#include "scene/scene.h"
#include "scene/window.h"
#include "tool/outputs.h"

enum { TOOL_GOOD = 0, TOOL_FAILED = 1, TOOL_USAGE = 2 };

int tool_build(int argc, char **argv);
int tool_render(int argc, char **argv);
int tool_info(int argc, char **argv);
int tool_compare(int argc, char **argv);
int tool_gen(int argc, char **argv);
int tool_import(int argc, char **argv);
int tool_background(int argc, char **argv);
int tool_texels(int argc, char **argv);
int tool_accuracy(int argc, char **argv);
int tool_reference(int argc, char **argv);
int tool_export(int argc, char **argv);
int tool_operations(int argc, char **argv);
int tool_trees(int argc, char **argv);
int tool_floats(int argc, char **argv);
int tool_sweep(int argc, char **argv); /* becomes another program; before guard_start() */
int tool_price(int argc, char **argv);
int tool_load_board(int argc, char **argv);
int tool_view(int argc, char **argv);
int tool_movie(int argc, char **argv);

/* Prints the message of err; returns TOOL_FAILED. */
int tool_failed(const struct sph_error *err);

/* argp_parse() with the options of its help that ours has, and no others. */
void tool_parse(const struct argp *argp, int argc, char **argv, unsigned flags, void *input);

/* ---- values of options; a wrong one ends the program with a usage message ---- */

/* Position of arg in choices, a list that ends with NULL. */
int tool_choice(const struct argp_state *state, const char *option, const char *arg,
                const char *const *choices);

/* A decimal number min .. max. */
unsigned long long tool_number(const struct argp_state *state, const char *option, const char *arg,
                               unsigned long long min, unsigned long long max);

/* A number min .. max. */
double tool_real(const struct argp_state *state, const char *option, const char *arg, double min,
                 double max);

/* least to most numbers of -limit .. limit with commas between them; those not given become 0. */
void tool_reals(const struct argp_state *state, const char *option, const char *arg, double limit,
                int least, int most, double *values);

/* WIDTHxHEIGHT, both 1 .. SPH_MAX_SIDE. */
void tool_size(const struct argp_state *state, const char *option, const char *arg, int *width,
               int *height);

/* The one argument of a command: takes it into *input; another, or none (the text `missing`), is a
 * usage error. Returns what argp's parser has to: ARGP_ERR_UNKNOWN for any other key. */
error_t tool_one_scene(const struct argp_state *state, int key, char *arg, const char **input,
                       const char *missing);

/* ---- from a scene to a machine ---- */

enum { TOOL_SAMPLES = 16 }; /* the most */

enum { TOOL_AUTO, TOOL_BVH4, TOOL_BIH, TOOL_BRUTE, TOOL_BOX4 };

enum { TOOL_EFFECTS_ALL, TOOL_EFFECTS_MET }; /* that the scene names; that rays of the frame meet */

struct tool_source {
    struct sph_build_options build;
    struct sph_read_options read;
    struct sph_aim aim;           /* of the scene's camera */
    struct sph_profile profile;   /* what build.widths points to, if --profile was given */
    int profile_auto;             /* the scene's own */
    struct sph_error_bound bound; /* what its profile must not miss */
    int accel, tree_given;        /* TOOL_AUTO ..; --tree was given */
    int refit;                    /* SPH_REFIT_*: of frames behind the first of several */
    double loss;                  /* of SPH_REFIT_AUTO */
    int samples;                  /* across and down a pixel: the frame is as many times larger */
    const char *bih_option;       /* the last option given that is for a BIH alone */
    const char *spans_option;     /* that is for --background spans alone */
    int levels_given;             /* --bg-levels, for --background exact */
    int every_background;         /* the command compares them all */
    int effects;                  /* TOOL_EFFECTS_* */
    const char *option;           /* the last build option given, NULL if none */
    struct tool_outputs outputs;  /* of the command: none may be a file that is read */
};

/* Options of build, for every command that takes a scene; its input is a struct tool_source. */
extern const struct argp tool_source_argp;
extern const struct argp tool_accel_argp, tool_effects_argp; /* parts of it */
extern const struct argp tool_scene_argp;     /* the part of commands that build no machine */
extern const char *const tool_filter_names[]; /* SPH_FILTER_*, then NULL */
extern const struct tool_source tool_source_default;

/* What a command takes that reports of one scene, and nothing else: it, --json, tool_source_argp as
 * its only child. tool_report_key() is its parser; `missing` as for tool_one_scene(). */
struct tool_report_arguments {
    struct tool_source source;
    const char *input, *json;
};
extern const struct argp_option tool_report_options[];
error_t tool_report_key(int key, char *arg, struct argp_state *state, const char *missing);

/* Writes a scene as NFF to output (NULL or -: standard output), says so, and frees it. */
int tool_write_scene(const char *output, struct sph_scene *scene, struct sph_error *err);

/* Is path a machine file, by its name (.sph) or its first bytes? */
int tool_is_machine(const char *path);

/* -1 with a message if it is, where only a scene will do. */
int tool_wants_scene(const char *path, struct sph_error *err);

/* -1 with a message if it is not, where only a machine file will do. */
int tool_wants_machine(const char *path, struct sph_error *err);

/* The size of the frame, in *build: the one asked for, or the scene's, times the samples. -1 with a
 * message if that is too large. */
int tool_frame_size(const struct tool_source *source, const struct sph_scene *scene,
                    struct sph_build_options *build, struct sph_error *err);

/* Reads the scene file at path, and aims its camera, unless an output would overwrite it or an
 * image of it. 0, or -1 with a message and nothing to free. */
int tool_scene_read(const char *path, const struct tool_source *source, struct sph_scene *scene,
                    struct sph_error *err);

struct tool_built {
    struct sph_machine machine;
    int from_scene; /* the fields below are set */
    struct sph_build_report report;
    struct sph_known_picture picture; /* of its widths */
    char profile_why[512];            /* empty if the profile was asked for */
};

/* With --profile auto: the options, which have the size of the frame, get the cheapest profile that
 * keeps what is asked for, or the finest. */
int tool_profile(const struct tool_source *source, const struct sph_scene *scene,
                 struct sph_build_options *build, struct sph_profile_choice *choice,
                 struct sph_error *err);

/* Builds the scene; with --profile auto a profile that cannot hold it gives way to the next. 0, or
 * -1 with a message. */
int tool_build_scene(const struct tool_source *source, const struct sph_scene *scene,
                     const struct sph_mip *mips, struct tool_built *built, struct sph_error *err);

/* Reads the machine file, or reads and builds the scene file, at path, unless an output would
 * overwrite it. 0, or -1 with a message. */
int tool_load(const char *path, const struct tool_source *source, struct tool_built *built,
              struct sph_error *err);

#endif
