/* test_view.c - the live view without its window: camera, keys, script, turned rays, colours
 * SPDX-License-Identifier: Apache-2.0
 */
#include "model_scene.h"

#include <math.h>
#include <unistd.h>

#include "engine/layers.h"
#include "fast/fast.h"
#include "scene/vector.h"
#include "view/camera.h"
#include "view/meter.h"
#include "view/pick.h"
#include "view/script.h"
#include "view/state.h"

static const struct sph_camera camera = {
    .from = {3, 2, 6}, .at = {1, 0, -1}, .up = {0, 1, 0}, .angle = 40, .width = 64, .height = 36};
static const double tiny = 1e-12; /* of doubles, a few operations */

static void near(double a, double b) {
    if (!(fabs(a - b) <= tiny * (1 + fabs(a)))) fail_msg("%.17g is not %.17g", a, b);
}

static void same_place(struct sph_vec a, struct sph_vec b) {
    near(a.x, b.x);
    near(a.y, b.y);
    near(a.z, b.z);
}

/* Where a point is seen in a picture of 64x36. */
static void seen(const struct sph_camera *c, struct sph_vec p, double *x, double *y) {
    double ends[4];
    assert_true(view_line(c, 64, 36, p, p, ends));
    *x = ends[0], *y = ends[1];
}

static void test_orbit(void **state) {
    (void)state;
    struct sph_camera c = camera;
    view_orbit(&c, 0.7, 0.1);
    near(view_distance(&c), view_distance(&camera));
    same_place(c.at, camera.at);
    view_orbit(&c, 0, -0.1);
    view_orbit(&c, -0.7, 0);
    same_place(c.from, camera.from);
    for (int up = -1; up <= 1; up += 2) { /* never over the pole */
        c = camera;
        view_orbit(&c, 0, 9 * up);
        struct sph_vec away = sph_vec_sub(c.from, c.at);
        near(up * away.y / view_distance(&c), cos(VIEW_POLE));
        view_orbit(&c, 0.3, 0.3 * up);
        assert_true(isfinite(c.from.x + c.from.y + c.from.z));
    }
}

/* The pointer is the head: what lies on the screen stays where it is seen, what lies behind it
 * comes along with the eye; then the eye is where it was. */
static void test_head(void **state) {
    struct view_state s;
    struct sph_build_options build = SPH_BUILD_DEFAULT;
    struct view_event f = {.kind = VIEW_KEY_DOWN, .key = "f"},
                      to = {.kind = VIEW_MOVE, .x = 60, .y = 5};
    struct sph_vec behind = {0.5, -0.5, -2.5}; /* as far behind `at` as that is from the eye / 6 */
    double was[4], is[4];
    (void)state;
    view_state_start(&s, &camera, &build);
    seen(&s.camera, camera.at, &was[0], &was[1]);
    seen(&s.camera, behind, &was[2], &was[3]);
    view_state_input(&s, &to, 0);
    same_place(s.camera.from, camera.from);
    view_state_input(&s, &f, 0);
    assert_int_equal(view_state_input(&s, &to, 0), 1);
    near(view_distance(&s.camera), view_distance(&camera));
    near(s.camera.angle, camera.angle);
    seen(&s.camera, camera.at, &is[0], &is[1]);
    seen(&s.camera, behind, &is[2], &is[3]);
    near(is[0], was[0]);
    near(is[1], was[1]);
    struct sph_vec eye = sph_vec_sub(s.camera.from, s.camera.at);
    near(sph_vec_dot(eye, sph_vec_sub(s.camera.at, camera.at)), 0); /* along the screen */
    assert_true(is[2] > was[2] + 1 && is[3] < was[3] - 1);
    seen(&s.camera, s.camera.at, &is[0], &is[1]); /* the eye is in front of the pointer */
    near(is[0], 60 - 0.5);
    near(is[1], 5 - 0.5);
    view_state_input(&s, &f, 0);
    same_place(s.camera.from, camera.from);
    near(s.camera.shift[0], 0);
    near(s.camera.shift[1], 0);
}

#define COS_30 0.86602540378443864676

/* Each from a camera at 0 0 5 that looks at the origin. */
static void test_moves(void **state) {
    (void)state;
    static const struct {
        void (*move)(struct sph_camera *c, double right, double up);
        double right, up; /* half turns */
        struct sph_vec from, at;
    } turns[] = {
        {view_orbit, 0.5, 0, {5, 0, 0}, {0, 0, 0}},                  /* a quarter to its right */
        {view_look, 0.5, 0, {0, 0, 5}, {5, 0, 5}},                   /* it looks to the right */
        {view_look, 0, 1.0 / 6, {0, 0, 5}, {0, 2.5, 5 - 5 * COS_30}} /* up by 30 degrees */
    };
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        struct sph_camera c = {.from = {0, 0, 5}, .up = {0, 2, 0}, .angle = 40};
        turns[i].move(&c, turns[i].right * acos(-1.0), turns[i].up * acos(-1.0));
        same_place(c.from, turns[i].from);
        same_place(c.at, turns[i].at);
    }
    struct sph_camera c = {.from = {0, 0, 5}, .up = {0, 1, 0}, .angle = 40};
    view_walk(&c, 1, 2, 3); /* right, up, ahead */
    same_place(c.from, (struct sph_vec){1, 2, 2});
    same_place(c.at, (struct sph_vec){1, 2, -3});
    view_near(&c, 0.5);
    same_place(c.from, (struct sph_vec){1, 2, -0.5});
}

/* What lies at the distance of `at` follows a finger. */
static void test_pan(void **state) {
    (void)state;
    struct sph_camera c = camera;
    double before[2], after[2];
    seen(&c, c.at, &before[0], &before[1]);
    near(before[0], 31.5);
    near(before[1], 17.5);
    struct sph_vec point = c.at;
    view_pan(&c, 0.25, -0.125);
    seen(&c, point, &after[0], &after[1]);
    near(after[0] - before[0], 9);
    near(after[1] - before[1], -4.5);
}

static void test_angle(void **state) {
    (void)state;
    struct sph_camera c = camera;
    view_angle(&c, 2);
    near(tan(c.angle / 360 * acos(-1.0)), 2 * tan(40.0 / 360 * acos(-1.0)));
    view_angle(&c, 1e9);
    near(c.angle, VIEW_WIDE);
    view_angle(&c, 1e-9);
    near(c.angle, VIEW_NARROW);
}

/* A line that comes from behind is cut where the camera stands, on its own way. */
static void test_line(void **state) {
    (void)state;
    struct sph_camera c = {.from = {0, 0, 5}, .up = {0, 1, 0}, .angle = 90};
    struct sph_vec ahead = {1, 1, 0}, behind = {1, 1, 10};
    double whole[4], back[4];
    assert_false(view_line(&c, 64, 36, behind, behind, whole));
    assert_true(view_line(&c, 64, 36, ahead, (struct sph_vec){1, 1, 4}, whole));
    near(whole[0], 31.5 + 18 / 5.0);
    near(whole[1], 17.5 - 18 / 5.0);
    assert_true(view_line(&c, 64, 36, behind, ahead, back));
    near(back[2], whole[0]);
    near(back[3], whole[1]);
    near((back[0] - 31.5), -(back[1] - 17.5)); /* on the diagonal, as all of the line */
    assert_true(back[0] > 1000);
}

static void test_keys(void **state) {
    (void)state;
    int does[VIEW_DO_NOTHING] = {0};
    for (const struct view_key *k = view_keys; k->text; k++) {
        if (!k->name) continue;
        assert_in_range(k->does, 0, VIEW_DO_NOTHING - 1);
        assert_int_equal(view_key_does(k->name), k->does); /* no name twice */
        does[k->does]++;
    }
    for (int i = 0; i < VIEW_DO_NOTHING; i++)
        if (does[i] != 1) fail_msg("%d keys do %d", does[i], i);
    assert_int_equal(view_key_does("ESCAPE"), VIEW_DO_QUIT);
    assert_int_equal(view_key_does("F12"), VIEW_DO_NOTHING);
}

static struct view_state start(void) {
    struct view_state s;
    static const struct sph_build_options build = SPH_BUILD_DEFAULT;
    view_state_start(&s, &camera, &build);
    return s;
}

static int input(struct view_state *s, struct view_event event, double now) {
    return view_state_input(s, &event, now);
}

static void test_mouse(void **state) {
    (void)state;
    struct view_state s = start();
    struct view_event down = {.kind = VIEW_BUTTON_DOWN, .button = VIEW_BUTTON_LEFT, .x = 9, .y = 8};
    struct view_event up = {.kind = VIEW_BUTTON_UP, .button = VIEW_BUTTON_LEFT, .x = 10, .y = 8};
    input(&s, down, 0);
    assert_true(input(&s, up, 0));
    assert_true(s.clicked && s.x == 10 && s.y == 8);
    assert_int_equal(s.camera_changes, 1);
    s.clicked = 0;
    input(&s, down, 0);
    assert_true(input(&s, (struct view_event){.kind = VIEW_MOVE, .x = 27, .y = 8}, 0));
    up.x = 27;
    input(&s, up, 0);
    assert_false(s.clicked);
    struct sph_camera c = camera; /* half the height to the right: half a turn to the left */
    view_orbit(&c, -acos(-1.0) / 2, 0);
    same_place(s.camera.from, c.from);
    assert_false(input(&s, (struct view_event){.kind = VIEW_MOVE, .x = 1, .y = 1}, 0));
}

static void test_fingers(void **state) {
    (void)state;
    struct view_state s = start();
    struct sph_camera c = camera;
    input(&s, (struct view_event){.kind = VIEW_FINGER, .x = 0.25, .y = 0.5}, 0);
    view_pan(&c, 0.25 * 64 / 36, 0.5);
    same_place(s.camera.from, c.from);
    input(&s, (struct view_event){.kind = VIEW_PINCH, .y = 0.5}, 0);
    view_walk(&c, 0, 0, view_distance(&camera) / 2);
    same_place(s.camera.from, c.from);
}

/* A touch of a key is a step; held, it goes on with time. */
static void test_hold(void **state) {
    (void)state;
    struct view_state s = start();
    struct sph_camera c = camera;
    input(&s, (struct view_event){.kind = VIEW_KEY_DOWN, .key = "W"}, 1);
    view_walk(&c, 0, 0, view_distance(&camera) / 2 * VIEW_TAP);
    same_place(s.camera.from, c.from);
    assert_true(view_state_hold(&s, 1 + VIEW_HOLD / 2));
    same_place(s.camera.from, c.from);
    view_state_hold(&s, 1 + VIEW_HOLD + 0.25);
    view_state_hold(&s, 1 + VIEW_HOLD + 0.5);
    view_walk(&c, 0, 0, view_distance(&camera) / 2 * 0.5);
    same_place(s.camera.from, c.from);
    input(&s, (struct view_event){.kind = VIEW_KEY_UP, .key = "W"}, 3);
    assert_false(view_state_hold(&s, 4));
    same_place(s.camera.from, c.from);
}

static void test_settings(void **state) {
    (void)state;
    static const char *const keys[] = {"t", "b", "n", "p"};
    static const int times[] = {SPH_TREE_LAST, 4, SPH_MAX_DEPTH + 1, SPH_PROFILES};
    char first[256], words[256];
    for (int k = 0; k < 4; k++) {
        struct view_state s = start();
        view_state_words(&s.build, first, sizeof first);
        for (int i = 1; i <= times[k]; i++) { /* once around */
            struct view_event key = {.kind = VIEW_KEY_DOWN};
            strcpy(key.key, keys[k]);
            input(&s, key, 0);
            assert_int_equal(s.build_changes, 1 + i);
            view_state_words(&s.build, words, sizeof words);
            assert_int_equal(!strcmp(words, first), i == times[k]);
        }
    }
}

/* A profile that was asked for by name is followed by the next, other widths by the first. */
static void test_profile(void **state) {
    (void)state;
    static const char *const asked[][2] = {{"standard", "fine"}, {"standard:pq=12", "draft"}};
    for (int i = 0; i < 2; i++) {
        struct view_state s = start();
        struct sph_profile widths;
        struct sph_error err = {""};
        assert_int_equal(sph_profile_parse(asked[i][0], &widths, &err), 0);
        s.build.widths = &widths;
        input(&s, (struct view_event){.kind = VIEW_KEY_DOWN, .key = "p"}, 0);
        assert_string_equal(sph_build_profile(&s.build)->name, asked[i][1]);
    }
}

/* ---- script ---- */

static char script_path[] = "/tmp/test_view.XXXXXX";

static int read_script(const char *text, struct view_script *script, struct sph_error *err) {
    FILE *file = fopen(script_path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return view_script_read(script_path, script, err);
}

static void test_script(void **state) {
    (void)state;
    struct view_script s;
    struct sph_error err = {""};
    assert_int_equal(read_script("# all\nkey Left # turns\n\n move 3 -4.5 250\nmove 1 2\n"
                                 "press right\nwait 20\nwait refined\nscreenshot a/b.png\nquit\n",
                                 &s, &err),
                     0);
    static const struct {
        int what, line;
        const char *text;
        double number[3];
        int button;
    } said[] = {{VIEW_SAY_KEY, 2, "Left", {0}, 0},
                {VIEW_SAY_MOVE, 4, "", {3, -4.5, 250}, 0},
                {VIEW_SAY_MOVE, 5, "", {1, 2, 0}, 0},
                {VIEW_SAY_PRESS, 6, "", {0}, VIEW_BUTTON_RIGHT},
                {VIEW_SAY_WAIT, 7, "", {20}, 0},
                {VIEW_SAY_REFINED, 8, "", {0}, 0},
                {VIEW_SAY_SCREENSHOT, 9, "a/b.png", {0}, 0},
                {VIEW_SAY_QUIT, 10, "", {0}, 0}};
    assert_int_equal(s.n, sizeof said / sizeof *said);
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        assert_int_equal(s.list[i].what, said[i].what);
        assert_int_equal(s.list[i].line, said[i].line);
        assert_string_equal(s.list[i].text, said[i].text);
        for (int k = 0; k < 3; k++)
            near(s.list[i].number[k], said[i].number[k]);
        if (said[i].button) assert_int_equal(s.list[i].button, said[i].button);
    }
    view_script_free(&s);
}

static void test_bad_script(void **state) {
    (void)state;
    static const char *const bad[][2] = {
        {"jump 3\n", ":1: there is no command `jump`"},
        {"\nmove 3\n", ":2: something is missing: move X Y [MILLISECONDS]"},
        {"move 3 4 5 6\n", ":1: `6` is too much: move"},
        {"move 3 x\n", ":1: `x` is wrong: move"},
        {"wheel inf\n", ":1: `inf` is wrong"},
        {"key F12\n", ":1: `F12` is wrong: key NAME"},
        {"press up\n", ":1: `up` is wrong: press left|middle|right"},
        {"wait -1\n", ":1: `-1` is wrong: wait"},
        {"screenshot\n", ":1: something is missing: screenshot FILE"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct view_script s;
        struct sph_error err = {""};
        assert_int_equal(read_script(bad[i][0], &s, &err), -1);
        if (strncmp(err.text, script_path, strlen(script_path)) != 0 ||
            !strstr(err.text, bad[i][1]))
            fail_msg("%s is not the message of %s", err.text, bad[i][0]);
    }
}

/* ---- pictures ---- */

static struct sph_machine build(const struct sph_scene *scene, int profile) {
    struct sph_machine m;
    assert_true(model_build(scene, profile, SPH_TREE_BALANCED, SPH_BG_NONE, MODEL_W, MODEL_H, &m));
    return m;
}

static struct view_cell cell_of(const struct sph_machine *m, const struct view_aim *aim, int i) {
    static const struct sph_render_options literal = {0};
    struct sph_fast *fast = sph_fast_new(m, SPH_FAST_BEST);
    const struct sph_render_options how = {.traverse = SPH_TRAVERSE_FAST, .fast = fast};
    struct sph_machine copy;
    struct view_cell cell, same;
    view_aim_start(m, aim, &copy);
    view_cell_draw(&copy, aim, &literal, i % MODEL_W, i / MODEL_W, &cell);
    view_cell_draw(&copy, aim, &how, i % MODEL_W, i / MODEL_W, &same);
    assert_int_equal(same.id, cell.id);
    assert_int_equal(same.visits, cell.visits);
    assert_int_equal(same.depth, cell.depth);
    assert_memory_equal(same.colour, cell.colour, sizeof cell.colour);
    assert_memory_equal(same.light, cell.light, sizeof cell.light);
    assert_memory_equal(same.normal, cell.normal, sizeof cell.normal);
    assert_memory_equal(&same.distance, &cell.distance, sizeof cell.distance);
    sph_fast_free(fast);
    return cell;
}

/* Cells are the pixels of the golden model; distance and normal those of its layers. */
static void test_cells(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("sphereflake2");
    struct sph_machine m = build(&scene, SPH_STANDARD);
    struct view_aim own = view_aim_own(&m);
    struct sph_counters counters;
    int errors, hits = 0;
    struct sph_frame frame = model_render(&m, SPH_TRAVERSE_TREE, 1, &counters, &errors);
    struct sph_layer *layers = sph_layers_of(&m, &frame);
    for (int i = 0; i < MODEL_W * MODEL_H; i++) {
        struct view_cell cell = cell_of(&m, &own, i);
        const struct sph_pixel *p = &frame.pixels[i];
        assert_memory_equal(cell.colour, p->colour, sizeof cell.colour);
        assert_int_equal(cell.id, p->id);
        assert_int_equal(cell.visits, p->visits);
        assert_memory_equal(cell.normal, layers[i].normal, sizeof cell.normal);
        assert_int_equal(isfinite(cell.distance), p->key != 0);
        if (!p->key) continue;
        hits++;
        assert_true(cell.distance >= layers[i].depth);
        assert_true(cell.distance < 1.5f * layers[i].depth);
    }
    assert_true(hits > MODEL_W * MODEL_H / 8);
    free(layers);
    sph_frame_free(&frame);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* Turned rays show what the machine for that camera shows, but for edges. */
static void test_aim(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("sphereflake2");
    struct sph_machine m = build(&scene, SPH_FINE), there;
    struct view_aim aim, own;
    view_orbit(&scene.camera, 0.9, 0.4);
    view_walk(&scene.camera, 0.2, 0.1, 0.3);
    assert_int_equal(view_aim_at(&m, &scene.camera, &aim), 0);
    there = build(&scene, SPH_FINE);
    own = view_aim_own(&there);
    int other = 0, seen_ids = 0;
    for (int i = 0; i < MODEL_W * MODEL_H; i++) {
        struct view_cell a = cell_of(&m, &aim, i), b = cell_of(&there, &own, i);
        seen_ids += b.id != SPH_ID_NONE;
        other += a.id != b.id;
        if (a.id == b.id && isfinite(b.distance))
            assert_true(fabsf(a.distance - b.distance) < 1e-2f * b.distance);
    }
    assert_true(seen_ids > MODEL_W * MODEL_H / 8);
    if (other > MODEL_W * MODEL_H / 50) fail_msg("%d pixels see something else", other);
    view_walk(&scene.camera, 0, 0, -1e6);
    assert_int_equal(view_aim_at(&m, &scene.camera, &aim), -1); /* off the grid */
    sph_machine_free(&m);
    sph_machine_free(&there);
    sph_scene_free(&scene);
}

/* The rays of a pixel start and end where they should, seen from the camera. */
static void test_pick(void **state) {
    (void)state;
    struct sph_scene scene = model_scene("sphereflake2");
    struct sph_machine m = build(&scene, SPH_FINE);
    struct sph_fast *fast = sph_fast_new(&m, SPH_FAST_BEST);
    struct view_job job = {&m, view_aim_own(&m), fast};
    struct sph_ray_log log;
    struct sph_pixel pixel;
    struct view_rays rays;
    int x = MODEL_W / 2, y = MODEL_H / 2;
    double ends[4];
    static uint32_t canvas[MODEL_W * MODEL_H];
    assert_int_equal(view_pick(&job, x, y, 10, &pixel, &log, &rays), 0);
    assert_true(pixel.key);
    assert_int_equal(rays.n, log.n);
    assert_true(rays.n >= 3);
    double off = sph_vec_length(sph_vec_sub(rays.list[0].from, scene.camera.from));
    assert_true(off < 1e-3);
    for (int i = 1; i < rays.n; i++) {
        struct sph_vec hit = rays.list[log.rays[i].parent].to;
        assert_true(sph_vec_length(sph_vec_sub(rays.list[i].from, hit)) < 1e-2);
        double to_light = INFINITY;
        for (int l = 0; l < scene.n_lights; l++)
            to_light =
                fmin(to_light, sph_vec_length(sph_vec_sub(rays.list[i].to, scene.lights[l].pos)));
        assert_int_equal(to_light < 1e-2, rays.list[i].kind == SPH_SHADOW);
    }
    struct sph_vec end = rays.list[0].to;
    assert_true(view_line(&scene.camera, MODEL_W, MODEL_H, end, end, ends));
    assert_true(fabs(ends[0] - x) < 0.1 && fabs(ends[1] - y) < 0.1);
    view_rays_draw(&rays, &scene.camera, MODEL_W, MODEL_H, canvas);
    int painted = 0;
    for (int i = 0; i < MODEL_W * MODEL_H; i++)
        painted += canvas[i] != 0;
    assert_true(painted >= 8);
    assert_int_equal(canvas[y * MODEL_W + x + 3], 0xffffff); /* an arm of the cross */
    assert_int_equal(canvas[(y - 3) * MODEL_W + x], 0xffffff);
    sph_ray_log_free(&log);
    view_rays_free(&rays);
    sph_fast_free(fast);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static void test_paint(void **state) {
    (void)state;
    static uint8_t srgb[VIEW_LIGHTS];
    srgb[0x1234] = 7, srgb[0x2345] = 8, srgb[0x3456] = 9;
    const struct view_truth truth[2] = {{0x030201, 5}, {0x030201, 6}};
    static const struct {
        int layer;
        uint32_t visits, colour;
        int at; /* pixel of truth, whose second is of another primitive; -1: there is none */
        uint32_t painted;
    } rows[] = {
        {VIEW_RENDERING, 1023, 0x030220, -1, 0},
        {VIEW_L1, 1023, 0x030220, -1, 0x090807}, /* by the table of sRGB */
        {VIEW_L2, 1023, 0x030220, -1, 0},
        {VIEW_DEPTHS, 1023, 0x030220, -1, 0x00ff00},
        {VIEW_VISITS, 1023, 0x030220, -1, 0xffffff},
        {VIEW_VISITS, 31, 0x030220, -1, 0x00ff00},     /* half of the logarithm */
        {VIEW_LEVELS, 1023, 0x030220, -1, 0x404040},   /* it has none */
        {VIEW_NORMALS, 1023, 0x030220, -1, 0xff8000},  /* -1, 0, 1 */
        {VIEW_DISTANCE, 1023, 0x030220, -1, 0x404040}, /* three times the middle one */
        {VIEW_DIFFERENCE, 1023, 0x030220, -1, 0},      /* light, until truth is known */
        {VIEW_DIFFERENCE, 31, 0x030220, 0, 0x0000ff},  /* 31 times 16: all */
        {VIEW_DIFFERENCE, 31, 0x030211, 0, 0x0000ff},
        {VIEW_DIFFERENCE, 31, 0x030001, 0, 0x002000},
        {VIEW_DIFFERENCE, 31, 0x030201, 0, 0},
        {VIEW_DIFFERENCE, 31, 0x030201, 1, 0xff0000}, /* another primitive */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct view_paint how = {.layer = rows[i].layer,
                                       .distance = 2,
                                       .srgb = srgb,
                                       .truth = rows[i].at < 0 ? NULL : truth};
        const struct view_cell cell = {.colour = {0, 0, rows[i].colour},
                                       .light = {{0}, {0x1234, 0x2345, 0x3456}},
                                       .id = 5,
                                       .visits = rows[i].visits,
                                       .normal = {-1, 0, 1},
                                       .distance = 6,
                                       .level = -1,
                                       .depth = 2};
        assert_int_equal(view_paint(&how, &cell, rows[i].at > 0), rows[i].painted);
    }
    assert_int_equal(view_heat(-1), 0);
    assert_int_equal(view_heat(0.5), 0x00ff00);
    assert_int_equal(view_heat(2), 0xffffff);
}

static void test_meter(void **state) {
    (void)state;
    struct view_meter m = {0};
    view_meter_input(&m, 1.00, 2);
    view_meter_input(&m, 1.02, 3);
    view_meter_shown(&m, 1.03, 1); /* an older picture answers neither */
    assert_int_equal(m.answers, 0);
    view_meter_shown(&m, 1.05, 2);
    assert_int_equal(m.answers, 1);
    view_meter_shown(&m, 1.15, 3);
    assert_int_equal(m.answers, 2);
    assert_int_equal(m.late, 1);
    near(m.worst, 1.15 - 1.02);
    assert_int_equal(m.pictures, 2);
    near(m.moving, 0.12);
}

static int make_script(void **state) {
    (void)state;
    return close(mkstemp(script_path));
}

static int remove_script(void **state) {
    (void)state;
    return unlink(script_path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit),    cmocka_unit_test(test_moves),
        cmocka_unit_test(test_pan),      cmocka_unit_test(test_head),
        cmocka_unit_test(test_angle),    cmocka_unit_test(test_line),
        cmocka_unit_test(test_keys),     cmocka_unit_test(test_mouse),
        cmocka_unit_test(test_fingers),  cmocka_unit_test(test_hold),
        cmocka_unit_test(test_settings), cmocka_unit_test(test_profile),
        cmocka_unit_test(test_script),   cmocka_unit_test(test_bad_script),
        cmocka_unit_test(test_cells),    cmocka_unit_test(test_aim),
        cmocka_unit_test(test_pick),     cmocka_unit_test(test_paint),
        cmocka_unit_test(test_meter),
    };
    return cmocka_run_group_tests(tests, make_script, remove_script);
}
