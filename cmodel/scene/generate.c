/* generate.c - chooses the maker of a generated scene; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/generate.h"
#include "scene/generate_kinds.h"
#include "common/number.h"

#include <string.h>
#include <unistd.h>

const char sph_generate_help[] =
    "sphereflake       SPD `balls` without floor: 10, 91, 820, 7381, 66430 spheres (size 1 to 5)\n"
    "paper5            5 random spheres, one light (Borodavka 2015, Fig. 10; seed)\n"
    "paper100          100 random spheres, one light (Borodavka 2015, Fig. 12; seed)\n"
    "interpenetrating  spheres that cut each other\n"
    "random            n spheres in a cube (n, seed)\n"
    "swarm             4096 such spheres, each moving its own way (n, seed, drift)\n"
    "huge_tiny         one huge sphere under small and tiny ones\n"
    "icosphere         80, 320, 1280, 5120, 20480 triangles over a plane (size 1 to 5)\n"
    "scenario1         n spheres in a lattice, a plane, one light (Aroxa 2014, IV.B; n, radius)\n"
    "scenario2         in the corners of a cube at random (n, radius, seed)\n"
    "scenario3         half and half (n, radius, seed)\n"
    "jacks             crossed bars with balls on their ends, 1 to 25 of them (size 1 to 5)\n"
    "lattice           8, 27, 64, 125, 216 balls and the bars between them (size 1 to 5)\n"
    "tree              7, 15, 31, 63, 127 cones that branch (size 1 to 5)\n"
    "rings             1 to 5 rings of balls and bars, one through the other (size 1 to 5)\n"
    "balls             sphereflake over a square floor (size 1 to 5)\n"
    "mount             128, 512, .. 32768 triangles, four mirrored balls (size 1 to 5, seed)\n"
    "tetra             4, 16, .. 1024 tetrahedra of one (size 1 to 5)\n"
    "shells            1 to 5 spirals of 48 spheres (size 1 to 5)\n"
    "cover             480 small spheres and three big ones on one of radius 1000 (seed)\n"
    "cornell           a room with coloured walls and two blocks\n"
    "horizon           a ball above a plane\n";

static const struct {
    const char *kind;
    int (*make)(const struct sph_generate_options *, struct sph_scene *, struct sph_error *);
    int takes;
} makers[] = {
    {"sphereflake", sph_make_sphereflake, SPH_TAKES_SIZE},
    {"paper5", sph_make_paper5, SPH_TAKES_SEED},
    {"paper100", sph_make_paper100, SPH_TAKES_SEED},
    {"interpenetrating", sph_make_interpenetrating, SPH_TAKES_NOTHING},
    {"random", sph_make_random, SPH_TAKES_N},
    {"swarm", sph_make_random, SPH_TAKES_N},
    {"huge_tiny", sph_make_huge_tiny, SPH_TAKES_NOTHING},
    {"icosphere", sph_make_icosphere, SPH_TAKES_SIZE},
    {"scenario1", sph_make_scenario1, SPH_TAKES_N},
    {"scenario2", sph_make_scenario2, SPH_TAKES_N},
    {"scenario3", sph_make_scenario3, SPH_TAKES_N},
    {"jacks", sph_make_jacks, SPH_TAKES_SIZE},
    {"lattice", sph_make_lattice, SPH_TAKES_SIZE},
    {"tree", sph_make_tree, SPH_TAKES_SIZE},
    {"rings", sph_make_rings, SPH_TAKES_SIZE},
    {"balls", sph_make_balls, SPH_TAKES_SIZE},
    {"mount", sph_make_mount, SPH_TAKES_SIZE},
    {"tetra", sph_make_tetra, SPH_TAKES_SIZE},
    {"shells", sph_make_shells, SPH_TAKES_SIZE},
    {"cover", sph_make_cover, SPH_TAKES_SEED},
    {"cornell", sph_make_cornell, SPH_TAKES_NOTHING},
    {"horizon", sph_make_horizon, SPH_TAKES_NOTHING},
};

enum { N_MAKERS = sizeof makers / sizeof makers[0] };

/* Of a swarm, if nothing else is said: spheres, scene units a frame. */
#define SWARM 4096
#define SWARM_DRIFT 0.1

static int check_distinct(const struct sph_scene *scene, struct sph_error *err) {
    uint32_t first, second;
    int found = sph_scene_duplicate(scene, &first, &second, err);
    if (found > 0)
        return sph_fail(err, "%s: spheres %u and %u are the same; try another seed", scene->name,
                        first, second);
    return found;
}

int sph_generate_takes(const char *kind) {
    for (int i = 0; i < N_MAKERS; i++)
        if (!strcmp(kind, makers[i].kind)) return makers[i].takes;
    return SPH_TAKES_UNKNOWN;
}

int sph_generate_parse(const char *text, char kind[32], struct sph_generate_options *options,
                       struct sph_error *err) {
    const char *colon = strchr(text, ':');
    size_t length = colon ? (size_t)(colon - text) : strlen(text);
    uint64_t n = 0, most = UINT64_MAX;
    if (length >= 32) return 0;
    memcpy(kind, text, length);
    kind[length] = 0;
    int takes = sph_generate_takes(kind);
    if (takes == SPH_TAKES_UNKNOWN || (takes == SPH_TAKES_NOTHING && colon)) return 0;
    if (!colon) return 1;
    if (takes == SPH_TAKES_SIZE) most = 5;
    if (takes == SPH_TAKES_N) most = SPH_MAX_SPHERES;
    if (sph_parse_count(colon + 1, takes != SPH_TAKES_SEED, most, &n))
        return sph_fail(err, "%.200s: '%.100s' is no number from %d to %llu", text, colon + 1,
                        takes != SPH_TAKES_SEED, (unsigned long long)most);
    if (takes == SPH_TAKES_SIZE) options->size = (int)n;
    if (takes == SPH_TAKES_N) options->n = (uint32_t)n;
    if (takes == SPH_TAKES_SEED) options->seed = n;
    return 1;
}

int sph_generate(const char *kind, const struct sph_generate_options *options,
                 struct sph_scene *scene, struct sph_error *err) {
    struct sph_generate_options o = {0};
    if (options) o = *options;
    if (!o.size) o.size = 2;
    int scenario = !strncmp(kind, "scenario", strlen("scenario")), swarm = !strcmp(kind, "swarm");
    if (!o.n) o.n = scenario ? 64 : swarm ? SWARM : 1000;
    if (swarm && !(o.drift > 0 || o.drift < 0)) o.drift = SWARM_DRIFT;
    if (!(o.radius != 0)) o.radius = 1;
    if (!o.width && !o.height) o.width = scenario ? 640 : 320, o.height = scenario ? 1088 : 180;
    memset(scene, 0, sizeof *scene);
    int i = 0;
    while (i < N_MAKERS && strcmp(kind, makers[i].kind) != 0)
        i++;
    if (i == N_MAKERS)
        return sph_fail(err, "cannot generate `%s`; known kinds:\n%s", kind, sph_generate_help);
    sph_scene_set_path(scene, kind);
    scene->camera.width = o.width;
    scene->camera.height = o.height;
    if (makers[i].make(&o, scene, err) || sph_camera_check(&scene->camera, scene->name, err) ||
        check_distinct(scene, err) || sph_make_moving(&o, scene, err)) {
        sph_scene_free(scene);
        return -1;
    }
    return 0;
}

int sph_scene_find(const char *text, const struct sph_read_options *options,
                   struct sph_scene *scene, struct sph_error *err) {
    struct sph_generate_options o = {0};
    char kind[32];
    int made = access(text, F_OK) ? sph_generate_parse(text, kind, &o, err) : 0;
    if (made < 0) return -1;
    return made ? sph_generate(kind, &o, scene, err) : sph_scene_read(text, options, scene, err);
}
