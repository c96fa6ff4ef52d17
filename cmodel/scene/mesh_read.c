/* mesh_read.c - a mesh by a process of its own; see mesh.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * assimp can be brought to fall by files that were made for it, to ask for all memory, or never to
 * come back. So a child loads it, reads, and sends what it read through a pipe: the scene's
 * numbers, then its arrays as they stand in memory. The parent believes no index of them.
 */
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/module.h"
#include "scene/mesh.h"

enum { CHUNK = 1 << 26 };
static const rlim_t most_memory = (rlim_t)8 << 30, most_seconds = 120; /* of a child */

/* What goes before the arrays. */
struct message {
    int bad;
    struct sph_error err;
    struct sph_scene scene;
};

/* The arrays that a mesh can have: where, of what size, how many, at most. */
struct array {
    void **at;
    size_t size;
    uint32_t n, most;
};
enum { ARRAYS = 4 };

static void arrays_of(struct sph_scene *s, struct array a[ARRAYS]) {
    a[0] = (struct array){(void **)&s->materials, sizeof *s->materials, s->n_materials, UINT32_MAX};
    a[1] = (struct array){(void **)&s->spheres, sizeof *s->spheres, s->n_spheres, SPH_MAX_SPHERES};
    a[2] = (struct array){(void **)&s->facets, sizeof *s->facets, s->n_facets, SPH_MAX_FACETS};
    a[3] =
        (struct array){(void **)&s->textures, sizeof *s->textures, s->n_textures, SPH_MAX_TEXTURES};
}

/* ---- the child ---- */

static void send(int to, const void *from, size_t n) {
    const char *at = from;
    while (n) {
        ssize_t got = write(to, at, n < CHUNK ? n : CHUNK);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) _exit(1);
        at += got, n -= (size_t)got;
    }
}

static void limit(void) {
    struct rlimit none = {0, 0}, seconds = {most_seconds, most_seconds};
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_CPU, &seconds);
#if !defined(__SANITIZE_ADDRESS__) /* whose own memory has no end */
    struct rlimit memory = {most_memory, most_memory};
    setrlimit(RLIMIT_DATA, &memory);
#endif
}

static int load(const char *path, enum sph_file_kind kind, const struct sph_import_options *o,
                struct sph_scene *scene, struct sph_error *err) {
    int (*read)(const char *, enum sph_file_kind, const struct sph_import_options *,
                struct sph_scene *, struct sph_error *);
    char why[400] = "";
    void *object = sph_module_load("mesh", why, sizeof why);
    void *found = object ? dlsym(object, "sph_mesh_load") : NULL;
    if (!found)
        return sph_fail(err, "%s: meshes are read by assimp, without which this was built: %s",
                        path, why);
    memcpy(&read, &found, sizeof read);
    return read(path, kind, o, scene, err);
}

static _Noreturn void child(const char *path, enum sph_file_kind kind,
                            const struct sph_import_options *o, const struct sph_scene *start,
                            int to) {
    struct message m = {.scene = *start};
    struct array a[ARRAYS];
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit();
    m.bad = load(path, kind, o, &m.scene, &m.err);
    send(to, &m, sizeof m);
    arrays_of(&m.scene, a);
    for (int i = 0; i < ARRAYS && !m.bad; i++)
        send(to, *a[i].at, a[i].n * a[i].size);
    _exit(0);
}

/* ---- the parent ---- */

/* Whether all n bytes come. */
static int receive(int from, void *to, size_t n) {
    char *at = to;
    while (n) {
        ssize_t got = read(from, at, n < CHUNK ? n : CHUNK);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return 0;
        at += got, n -= (size_t)got;
    }
    return 1;
}

static int sound(const struct sph_scene *s) {
    for (uint32_t i = 0; i < s->n_spheres; i++)
        if (s->spheres[i].material >= s->n_materials || s->spheres[i].texture) return 0;
    for (uint32_t i = 0; i < s->n_facets; i++)
        if (s->facets[i].material >= s->n_materials || s->facets[i].texture > s->n_textures ||
            s->facets[i].motion || s->facets[i].frustum)
            return 0;
    return s->n_lights >= 0 && s->n_lights <= SPH_MAX_LIGHTS;
}

/* Room for a power of two of elements, as edit.c expects that it added them one by one. */
static int take_array(int from, const struct array *a) {
    size_t room = 64;
    while (room < a->n)
        room *= 2;
    *a->at = NULL;
    if (a->n > a->most) return 0;
    if (!a->n) return 1;
    *a->at = malloc(room * a->size);
    return *a->at && receive(from, *a->at, a->n * a->size);
}

/* 1: the scene, or an error, came whole. */
static int take(int from, struct sph_scene *scene, struct sph_error *err) {
    static const struct sph_scene empty;
    struct message *m = malloc(sizeof *m);
    struct array a[ARRAYS];
    int whole = m && receive(from, m, sizeof *m);
    if (whole && m->bad) {
        m->err.text[sizeof m->err.text - 1] = 0;
        sph_fail(err, "%s", m->err.text);
    } else if (whole) {
        *scene = m->scene;
        scene->motions = empty.motions, scene->flights = empty.flights;
        scene->frusta = empty.frusta, scene->files = empty.files;
        scene->n_motions = scene->n_flights = scene->n_frusta = scene->n_files = 0;
        arrays_of(scene, a);
        for (int i = 0; i < ARRAYS; i++)
            *a[i].at = NULL;
        for (int i = 0; i < ARRAYS && whole; i++)
            whole = take_array(from, &a[i]);
        for (uint32_t i = 0; whole && i < scene->n_facets; i++)
            scene->facets[i].kind = SPH_TRIANGLE; /* a mesh has no other */
        whole = whole && sound(scene);
    }
    free(m);
    return whole;
}

/* How a child ended that did not say so itself. */
static int fail_ended(const char *path, int status, struct sph_error *err) {
    int by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (by == SIGXCPU || by == SIGKILL)
        return sph_fail(err, "%s: assimp was not done with this file within %d seconds, or %d GiB",
                        path, (int)most_seconds, (int)(most_memory >> 30));
    return sph_fail(err, "%s: assimp fell over this file%s%s", path, by ? ": " : "",
                    by ? strsignal(by) : "");
}

int sph_mesh_read(const char *path, enum sph_file_kind kind,
                  const struct sph_import_options *options, struct sph_scene *scene,
                  struct sph_error *err) {
    int ends[2], status = 0;
    if (pipe(ends)) return sph_fail(err, "%s: no pipe: %s", path, strerror(errno));
    pid_t id = fork();
    if (!id) {
        close(ends[0]);
        child(path, kind, options, scene, ends[1]);
    }
    int why = errno;
    close(ends[1]);
    int whole = id > 0 && take(ends[0], scene, err);
    close(ends[0]);
    if (id < 0) return sph_fail(err, "%s: no process to read it: %s", path, strerror(why));
    while (waitpid(id, &status, 0) < 0 && errno == EINTR)
        ;
    if (!whole) fail_ended(path, status, err);
    return whole && !err->text[0] ? 0 : -1;
}
