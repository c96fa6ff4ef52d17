/* cmd_sweep.c - `sphaera sweep`: finds the checkout whose `python3 -m lab sweep` does it
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tool/tool.h"

static const char command[] = "lab/sweep/command.py"; /* what a checkout has */

/* For --help alone: lab/sweep takes the words as they are, and knows what axes there are. */
enum {
    KEY_MEASURE = 256,
    KEY_SHOW,
    KEY_X,
    KEY_LINES,
    KEY_PANEL,
    KEY_HEAT,
    KEY_BESIDE,
    KEY_OUT,
    KEY_JOBS,
    KEY_ENGINE,
    KEY_LIST,
    KEY_AXES
};

static const struct argp_option options[] = {
    {"measure", KEY_MEASURE, "NAME...", 0,
     "counts (default: the model), accuracy (model and double reference), price (of `sphaera "
     "price`), cycles (the core in Verilator, each pixel held against the model), cells (Yosys)",
     0},
    {"show", KEY_SHOW, "FIGURE...", 0, "columns that are printed and drawn; sweep.csv has all", 0},
    {"x", KEY_X, "AXIS", 0, "of the plots; a panel for each value of the other axes", 0},
    {"lines", KEY_LINES, "AXIS", 0, "of which each value has a line", 0},
    {"panel", KEY_PANEL, "AXIS...", 0, "of which each value has a panel", 0},
    {"heat", KEY_HEAT, "X", 0, "and Y, axes of heat maps beside each other, instead of lines", 0},
    {"beside", KEY_BESIDE, "FILE", 0,
     "a CSV whose figures stand beside: of a paper, or the sweep.csv of another sweep. Its columns "
     "are axes, which tell its rows apart, and figures",
     0},
    {"out", KEY_OUT, "FOLDER", 0, "build/sweep/DIGEST, of what the sweep is", 0},
    {"jobs", KEY_JOBS, "N", 0, "that run at once (all processors)", 0},
    {"engine", KEY_ENGINE, "NAME", 0, "make (default), or slurm: on a cluster", 0},
    {"list", KEY_LIST, NULL, 0, "how many points and jobs there are; runs nothing", 0},
    {"axes", KEY_AXES, NULL, 0, "axes, with their values and what they shape", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    (void)key, (void)arg, (void)state;
    return 0;
}

/* Is there a checkout in the folder, or above it? Cuts path, an absolute one, to it. */
static int checkout(char path[PATH_MAX]) {
    for (char *end; (end = strrchr(path, '/')) != NULL; *end = '\0') {
        char file[PATH_MAX + sizeof command + 1];
        snprintf(file, sizeof file, "%s/%s", path, command);
        if (!access(file, R_OK)) return 1;
    }
    return 0;
}

/* Where this program lies; "" if that is not known. */
static void own_path(char path[PATH_MAX]) {
    ssize_t n = readlink("/proc/self/exe", path, PATH_MAX - 1);
    path[n > 0 ? n : 0] = '\0';
}

/* Runs `python3 -m lab sweep`, in the checkout that this program was built in, or that one is in.
 * Called before guard_start(): what it runs has limits and signals of its own. */
int tool_sweep(int argc, char **argv) {
    static const struct argp argp = {
        options,
        parse,
        "[FILE] [--AXIS VALUE...]...",
        "Measures every value of some axes with every other.\v"
        "N..M are numbers, each. --axes lists the axes: scene, size, profile and its widths, tree, "
        "accel, background, pipes, engines, sizes of the core, memory, latency ...\n\n"
        "Prints a table and leaves sweep.csv, with a row a point, and a plot of each figure shown. "
        "Results are kept by everything that shapes them, versions of tools among it, and are not "
        "measured again; a sweep that is broken off goes on from there. FILE has the same words, a "
        "line each, without --; what stands behind it counts instead. Runs in a checkout, since it "
        "needs its RTL and scripts.\n\n"
        "sphaera sweep --scene paper5 paper100 --profile draft standard --measure accuracy\n"
        "sphaera sweep --scene random:1000 --measure cycles --pipes 1..4 --latency 20 200",
        NULL,
        NULL,
        NULL};
    static char python[] = "python3", module[] = "-m", lab[] = "lab", sweep[] = "sweep";
    static char self[] = "sphaera sweep";
    char here[PATH_MAX], own[PATH_MAX], root[PATH_MAX];
    argv[0] = self;
    for (int i = 1; i < argc; i++)
        if (!strcmp(argv[i], "--help") || !strcmp(argv[i], "-?") || !strcmp(argv[i], "--usage")) {
            argv[1] = argv[i];
            tool_parse(&argp, 2, argv, 0, NULL);
        }
    if (!getcwd(here, sizeof here)) here[0] = '\0';
    own_path(own);
    memcpy(root, own, sizeof root);
    char *slash = strrchr(own, '/');
    if (checkout(root)) {
        *slash = '\0'; /* the folder of all that is built */
        setenv("BUILD", own, 1);
    } else {
        memcpy(root, here, sizeof root);
    }
    char **words = calloc((size_t)argc + 4, sizeof *words);
    if (!words || !checkout(root)) {
        fprintf(stderr, "sphaera: sweep runs in a checkout of Sphaera, and neither this folder nor "
                        "this program is in one\n");
        free(words);
        return TOOL_FAILED;
    }
    memcpy(words, (char *[]){python, module, lab, sweep}, 4 * sizeof *words);
    memcpy(words + 4, argv + 1, (size_t)(argc - 1) * sizeof *words);
    setenv("FROM", here, 1); /* of names of files */
    if (!chdir(root)) execvp(python, words);
    fprintf(stderr, "sphaera: sweep: %s\n", strerror(errno));
    free(words);
    return TOOL_FAILED;
}
