/* scoreboard.c - what another core draws against the model's frame: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sphaera/opaque.h"

struct sphaera_scoreboard {
    sphaera_machine *machine;
    sphaera_frame *frame;
    uint8_t *came; /* of each pixel of the frame */
    size_t pixels; /* that came */
    int differ;    /* differences of this frame */
    int fresh;     /* a new frame has begun: the text is of the one before */
    char *text;    /* NULL: none */
};

static const int32_t *window(const sphaera_scoreboard *b) {
    return b->machine->machine.regs + SPH_REG_WIN_X0;
}

static const struct sph_pixel *expected(const sphaera_scoreboard *b, int x, int y) {
    return &b->frame->frame.pixels[(size_t)y * (size_t)b->frame->frame.width + (size_t)x];
}

int sphaera_scoreboard_new(const sphaera_machine *machine, int threads, sphaera_scoreboard **board,
                           sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(board, "board", error)) return -1;
    struct sph_error err = {""};
    *board = NULL;
    sphaera_scoreboard *made = calloc(1, sizeof *made);
    if (!made) {
        sph_fail(&err, "no memory for a scoreboard");
        return sph_api_failed(&err, error);
    }
    made->machine = sph_api_hold(machine);
    int rc = sphaera_render(machine, threads, &made->frame, error);
    if (!rc) {
        const struct sph_frame *f = &made->frame->frame;
        made->came = calloc((size_t)f->width * (size_t)f->height, 1);
        if (!made->came) {
            sph_fail(&err, "no memory for a scoreboard");
            rc = sph_api_failed(&err, error);
        }
    }
    if (!rc) {
        *board = made;
        return 0;
    }
    sphaera_scoreboard_free(made);
    return -1;
}

void sphaera_scoreboard_free(sphaera_scoreboard *board) {
    if (!board) return;
    sphaera_frame_free(board->frame);
    sphaera_machine_free(board->machine);
    free(board->came);
    free(board->text);
    free(board);
}

/* Counts a difference. Where the text of the first one of a frame goes, to be closed; NULL: it is
 * not the first, or there is no memory for it. */
static FILE *differs(sphaera_scoreboard *b) {
    size_t size;
    if (b->fresh) {
        free(b->text);
        b->text = NULL;
        b->fresh = 0;
    }
    return b->differ++ ? NULL : open_memstream(&b->text, &size);
}

/* The stages of the rays of a pixel, a line each. */
static void put_stages(const sphaera_scoreboard *b, int x, int y, FILE *to) {
    sphaera_pixel *pixel = NULL;
    const char *line;
    if (sphaera_pixel_trace(b->machine, x, y, &pixel, NULL)) return;
    fprintf(to, "stages of the model:\n");
    for (int i = 0; (line = sphaera_pixel_text(pixel, i)) != NULL; i++)
        fprintf(to, "  %s\n", line);
    sphaera_pixel_free(pixel);
}

/* Whether a pixel may come, and marks it. */
static int take(sphaera_scoreboard *b, int x, int y) {
    const int32_t *w = window(b); /* x0, y0, x1, y1 */
    const char *why = NULL;
    if (x < w[0] || y < w[1] || x >= w[2] || y >= w[3])
        why = "lies outside the window";
    else if (b->came[(size_t)y * (size_t)b->frame->frame.width + (size_t)x]++)
        why = "comes a second time";
    if (!why) {
        b->pixels++;
        return 0;
    }
    FILE *to = differs(b);
    if (to) {
        fprintf(to, "pixel %d,%d %s\n", x, y, why);
        fclose(to);
    }
    return 1;
}

/* A field of a pixel. */
struct field {
    const char *name;
    uint64_t got, wanted;
};

static int compare(sphaera_scoreboard *b, int x, int y, const struct field *fields, int n) {
    int same = 1;
    for (int i = 0; i < n; i++)
        same &= fields[i].got == fields[i].wanted;
    if (same) return 0;
    FILE *to = differs(b);
    if (!to) return 1;
    fprintf(to, "pixel %d,%d differs\n", x, y);
    for (int i = 0; i < n; i++)
        fprintf(to, "  %-10s 0x%" PRIx64 ", expected 0x%" PRIx64 "%s\n", fields[i].name,
                fields[i].got, fields[i].wanted, fields[i].got == fields[i].wanted ? "" : "  <--");
    put_stages(b, x, y, to);
    fclose(to);
    return 1;
}

int sphaera_scoreboard_pixel(sphaera_scoreboard *board, int x, int y, uint32_t rendering,
                             uint32_t l1, uint32_t l2, uint32_t id, uint64_t key, uint32_t visits,
                             uint32_t texture) {
    SPH_API_ENVIRONMENT;
    if (take(board, x, y)) return 1;
    const struct sph_pixel *p = expected(board, x, y);
    const struct field fields[] = {
        {"rendering", rendering, p->colour[0]},
        {"l1", l1, p->colour[1]},
        {"l2", l2, p->colour[2]},
        {"id", id, p->id},
        {"key", key, p->key},
        {"visits", visits, p->visits},
        {"texture", texture, p->texture},
    };
    return compare(board, x, y, fields, sizeof fields / sizeof *fields);
}

int sphaera_scoreboard_colour(sphaera_scoreboard *board, int x, int y, uint32_t colour) {
    SPH_API_ENVIRONMENT;
    if (take(board, x, y)) return 1;
    int frame = board->machine->machine.regs[SPH_REG_FRAME];
    const struct field field = {
        "colour", colour,
        expected(board, x, y)->colour[frame < SPH_FRAMES ? frame : SPH_FRAMES - 1]};
    return compare(board, x, y, &field, 1);
}

static int whole(sphaera_scoreboard *b, const char *name, uint64_t got, uint64_t wanted) {
    if (got == wanted) return 0;
    FILE *to = differs(b);
    if (!to) return 1;
    fprintf(to, "%s: %" PRIu64 ", expected %" PRIu64 "\n", name, got, wanted);
    fclose(to);
    return 1;
}

int sphaera_scoreboard_counter(sphaera_scoreboard *board, int number, uint64_t value) {
    char name[64];
    if (!sphaera_counter_exact(number)) return 0;
    snprintf(name, sizeof name, "counter %s", sphaera_counter_name(number));
    return whole(board, name, value, sphaera_frame_counter(board->frame, number));
}

int sphaera_scoreboard_errors(sphaera_scoreboard *board, uint32_t bits) {
    return whole(board, "sticky errors", bits, board->frame->errors);
}

int sphaera_scoreboard_end(sphaera_scoreboard *board) {
    const int32_t *w = window(board);
    size_t width = (size_t)board->frame->frame.width, height = (size_t)board->frame->frame.height;
    size_t all = w[2] > w[0] && w[3] > w[1] ? (size_t)(w[2] - w[0]) * (size_t)(w[3] - w[1]) : 0;
    if (board->pixels != all) {
        FILE *to = differs(board);
        int x = w[0], y = w[1];
        while (board->came[(size_t)y * width + (size_t)x])
            if (++x == w[2]) x = w[0], y++;
        if (to) {
            fprintf(to, "%zu of %zu pixels did not come, the first of them is %d,%d\n",
                    all - board->pixels, all, x, y);
            fclose(to);
        }
    }
    int differ = board->differ;
    memset(board->came, 0, width * height);
    board->pixels = 0;
    board->differ = 0;
    board->fresh = 1;
    return differ;
}

const char *sphaera_scoreboard_text(const sphaera_scoreboard *board) {
    return board->text ? board->text : "";
}
