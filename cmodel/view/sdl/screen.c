/* screen.c - the window of the live view in SDL2; see view/screen.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "view/screen.h"

struct view_screen {
    SDL_Window *window;
    SDL_Renderer *renderer;
    SDL_Texture *texture;
    int width, height;
};

static void close_screen(struct view_screen *s) {
    if (!s) return;
    if (s->texture) SDL_DestroyTexture(s->texture);
    if (s->renderer) SDL_DestroyRenderer(s->renderer);
    if (s->window) SDL_DestroyWindow(s->window);
    SDL_Quit();
    free(s);
}

/* The module is not linked with the model. */
static struct view_screen *failed(struct view_screen *s, struct sph_error *err) {
    snprintf(err->text, sizeof err->text, "no window can be opened: %.400s", SDL_GetError());
    close_screen(s);
    return NULL;
}

static struct view_screen *open_screen(int width, int height, struct sph_error *err) {
    struct view_screen *s = calloc(1, sizeof *s);
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0"); /* fingers are told apart from the mouse */
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (!s || SDL_Init(SDL_INIT_VIDEO)) return failed(s, err);
    s->width = width, s->height = height;
    s->window = SDL_CreateWindow("sphaera view", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                 width, height, SDL_WINDOW_RESIZABLE);
    if (!s->window) return failed(s, err);
    s->renderer = SDL_CreateRenderer(s->window, -1, 0);
    if (!s->renderer) s->renderer = SDL_CreateRenderer(s->window, -1, SDL_RENDERER_SOFTWARE);
    if (!s->renderer || SDL_RenderSetLogicalSize(s->renderer, width, height)) return failed(s, err);
    s->texture = SDL_CreateTexture(s->renderer, SDL_PIXELFORMAT_BGR888, SDL_TEXTUREACCESS_STREAMING,
                                   width, height);
    return s->texture ? s : failed(s, err);
}

static void title(struct view_screen *s, const char *text) {
    SDL_SetWindowTitle(s->window, text);
}

static const int buttons[VIEW_BUTTONS] = {0, SDL_BUTTON_LEFT, SDL_BUTTON_MIDDLE, SDL_BUTTON_RIGHT};

static void button(const SDL_MouseButtonEvent *e, int kind, struct view_event *to) {
    for (int i = VIEW_BUTTON_LEFT; i < VIEW_BUTTONS; i++)
        if (e->button == buttons[i]) *to = (struct view_event){.kind = kind, .button = i};
    to->x = e->x, to->y = e->y;
}

static void key(const SDL_KeyboardEvent *e, int kind, struct view_event *to) {
    if (e->repeat) return; /* the view moves on by itself while a key is down */
    to->kind = kind;
    snprintf(to->key, sizeof to->key, "%s", SDL_GetKeyName(e->keysym.sym));
}

static void translate(const SDL_Event *e, struct view_event *to) {
    *to = (struct view_event){.kind = VIEW_NOTHING};
    switch (e->type) {
    case SDL_QUIT:
        to->kind = VIEW_CLOSED;
        break;
    case SDL_KEYDOWN:
        key(&e->key, VIEW_KEY_DOWN, to);
        break;
    case SDL_KEYUP:
        key(&e->key, VIEW_KEY_UP, to);
        break;
    case SDL_MOUSEBUTTONDOWN:
        button(&e->button, VIEW_BUTTON_DOWN, to);
        break;
    case SDL_MOUSEBUTTONUP:
        button(&e->button, VIEW_BUTTON_UP, to);
        break;
    case SDL_MOUSEMOTION:
        *to = (struct view_event){.kind = VIEW_MOVE, .x = e->motion.x, .y = e->motion.y};
        break;
    case SDL_MOUSEWHEEL:
        *to = (struct view_event){.kind = VIEW_WHEEL, .y = e->wheel.y};
        break;
    case SDL_FINGERMOTION:
        if (SDL_GetNumTouchFingers(e->tfinger.touchId) < 2)
            *to = (struct view_event){
                .kind = VIEW_FINGER, .x = (double)e->tfinger.dx, .y = (double)e->tfinger.dy};
        break;
    case SDL_MULTIGESTURE:
        *to = (struct view_event){.kind = VIEW_PINCH, .y = (double)e->mgesture.dDist};
        break;
    case SDL_WINDOWEVENT:
        to->kind = VIEW_EXPOSED;
        break;
    default:
        break;
    }
}

static int next(struct view_screen *s, double seconds, struct view_event *event) {
    SDL_Event e;
    (void)s;
    if (!SDL_WaitEventTimeout(&e, (int)(1000 * seconds))) return 0;
    translate(&e, event);
    return 1;
}

/* A place of the picture in the window, from where SDL brings it back to the picture. */
static void place(const struct view_screen *s, const struct view_event *event, int *x, int *y) {
    SDL_RenderLogicalToWindow(s->renderer, (float)event->x, (float)event->y, x, y);
}

static void push(struct view_screen *s, const struct view_event *event) {
    SDL_Event e;
    memset(&e, 0, sizeof e);
    switch (event->kind) {
    case VIEW_KEY_DOWN:
    case VIEW_KEY_UP:
        e.type = event->kind == VIEW_KEY_DOWN ? SDL_KEYDOWN : SDL_KEYUP;
        e.key.keysym.sym = SDL_GetKeyFromName(event->key);
        break;
    case VIEW_BUTTON_DOWN:
    case VIEW_BUTTON_UP:
        e.type = event->kind == VIEW_BUTTON_DOWN ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
        e.button.windowID = SDL_GetWindowID(s->window);
        e.button.button = (Uint8)buttons[event->button];
        place(s, event, &e.button.x, &e.button.y);
        break;
    case VIEW_MOVE:
        e.type = SDL_MOUSEMOTION;
        e.motion.windowID = SDL_GetWindowID(s->window);
        place(s, event, &e.motion.x, &e.motion.y);
        break;
    case VIEW_WHEEL:
        e.type = SDL_MOUSEWHEEL;
        e.wheel.y = (int)event->y;
        break;
    case VIEW_FINGER:
        e.type = SDL_FINGERMOTION;
        e.tfinger.dx = (float)event->x, e.tfinger.dy = (float)event->y;
        break;
    case VIEW_PINCH:
        e.type = SDL_MULTIGESTURE;
        e.mgesture.numFingers = 2;
        e.mgesture.dDist = (float)event->y;
        break;
    default:
        e.type = SDL_QUIT;
        break;
    }
    SDL_PushEvent(&e);
}

static void draw(struct view_screen *s) {
    SDL_SetRenderDrawColor(s->renderer, 0, 0, 0, 255);
    SDL_RenderClear(s->renderer);
    SDL_RenderCopy(s->renderer, s->texture, NULL, NULL);
}

static void show(struct view_screen *s, const uint32_t *pixels) {
    SDL_UpdateTexture(s->texture, NULL, pixels, 4 * s->width);
    draw(s);
    SDL_RenderPresent(s->renderer);
}

/* Drawn again: what was shown need not be there any more after it. */
static int read_back(struct view_screen *s, uint32_t *pixels, struct sph_error *err) {
    int width = 0, height = 0;
    SDL_GetRendererOutputSize(s->renderer, &width, &height);
    if (width != s->width || height != s->height) {
        snprintf(err->text, sizeof err->text,
                 "the window has %dx%d pixels, the picture %dx%d: no screenshot", width, height,
                 s->width, s->height);
        return -1;
    }
    draw(s);
    if (!SDL_RenderReadPixels(s->renderer, NULL, SDL_PIXELFORMAT_BGR888, pixels, 4 * width))
        return 0;
    snprintf(err->text, sizeof err->text, "no screenshot: %.400s", SDL_GetError());
    return -1;
}

__attribute__((visibility("default"))) extern const struct view_screen_calls view_screen_sdl;
const struct view_screen_calls view_screen_sdl = {open_screen, close_screen, title,    next,
                                                  push,        show,         read_back};
