/* script.c - see script.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/script.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/number.h"
#include "view/keys.h"
#include "view/screen.h"

enum { WORDS = 4, NUMBERS = 3, LONGEST_LINE = 1024 };

/* Arguments: k a key, b a button, f a file, w milliseconds or `refined`, n a number, m one that may
 * be left out. */
static const struct {
    const char *word, *takes, *usage;
} commands[] = {
    [VIEW_SAY_KEY] = {"key", "k", "key NAME"},
    [VIEW_SAY_DOWN] = {"down", "k", "down NAME"},
    [VIEW_SAY_UP] = {"up", "k", "up NAME"},
    [VIEW_SAY_PRESS] = {"press", "b", "press left|middle|right"},
    [VIEW_SAY_RELEASE] = {"release", "b", "release left|middle|right"},
    [VIEW_SAY_MOVE] = {"move", "nnm", "move X Y [MILLISECONDS]"},
    [VIEW_SAY_CLICK] = {"click", "nn", "click X Y"},
    [VIEW_SAY_WHEEL] = {"wheel", "n", "wheel CLICKS"},
    [VIEW_SAY_FINGER] = {"finger", "nn", "finger RIGHT DOWN"},
    [VIEW_SAY_PINCH] = {"pinch", "n", "pinch APART"},
    [VIEW_SAY_WAIT] = {"wait", "w", "wait MILLISECONDS|refined"},
    [VIEW_SAY_SCREENSHOT] = {"screenshot", "f", "screenshot FILE"},
    [VIEW_SAY_SCENE] = {"scene", "f", "scene FILE"},
    [VIEW_SAY_REPORT] = {"report", "", "report"},
    [VIEW_SAY_QUIT] = {"quit", "", "quit"},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int button_of(const char *word) {
    static const char *const names[VIEW_BUTTONS] = {"", "left", "middle", "right"};
    for (int i = VIEW_BUTTON_LEFT; i < VIEW_BUTTONS; i++)
        if (!strcmp(word, names[i])) return i;
    return 0;
}

static int number_of(const char *word, double *number) {
    return !sph_parse_number(word, number);
}

/* An argument of a kind; 0 if it is not one. */
static int take(struct view_say *say, char kind, const char *word, int *numbers) {
    switch (kind) {
    case 'k':
        snprintf(say->text, sizeof say->text, "%s", word);
        return view_key_does(word) != VIEW_DO_NOTHING;
    case 'f':
        snprintf(say->text, sizeof say->text, "%s", word);
        return strlen(word) < sizeof say->text;
    case 'b':
        say->button = button_of(word);
        return say->button;
    case 'w':
        if (!strcmp(word, "refined")) {
            say->what = VIEW_SAY_REFINED;
            return 1;
        }
        return number_of(word, &say->number[0]) && say->number[0] >= 0;
    default:
        return number_of(word, &say->number[(*numbers)++]);
    }
}

/* The words of a line; a # starts a comment. */
static int split(char *line, char *words[WORDS + 1]) {
    int n = 0;
    char *rest = NULL;
    line[strcspn(line, "#\n")] = 0;
    for (char *word = strtok_r(line, " \t\r", &rest); word && n <= WORDS;
         word = strtok_r(NULL, " \t\r", &rest))
        words[n++] = word;
    return n;
}

static int parse(const char *path, char *words[], int n, struct view_say *say,
                 struct sph_error *err) {
    int what = 0, given = 1, numbers = 0;
    while (what < COMMANDS && (!commands[what].word || strcmp(words[0], commands[what].word) != 0))
        what++;
    if (what == COMMANDS)
        return sph_fail(err, "%s:%d: there is no command `%s`", path, say->line, words[0]);
    say->what = what;
    for (const char *kind = commands[what].takes; *kind; kind++, given++) {
        if (given == n && *kind == 'm') break;
        if (given == n)
            return sph_fail(err, "%s:%d: something is missing: %s", path, say->line,
                            commands[what].usage);
        if (!take(say, *kind, words[given], &numbers))
            return sph_fail(err, "%s:%d: `%s` is wrong: %s%s", path, say->line, words[given],
                            commands[what].usage, *kind == 'k' ? "; key h prints their names" : "");
    }
    if (given < n)
        return sph_fail(err, "%s:%d: `%s` is too much: %s", path, say->line, words[given],
                        commands[what].usage);
    return 0;
}

/* Room for one more. */
static struct view_say *grow(struct view_script *script) {
    if (script->n & (script->n + 1)) return &script->list[script->n]; /* full before 1, 3, 7 .. */
    struct view_say *list = realloc(script->list, (2u * (size_t)script->n + 1) * sizeof *list);
    if (list) script->list = list;
    return list ? &list[script->n] : NULL;
}

static int read_lines(FILE *file, const char *path, struct view_script *script,
                      struct sph_error *err) {
    char line[LONGEST_LINE], *words[WORDS + 1];
    for (int number = 1; fgets(line, sizeof line, file); number++) {
        if (strlen(line) == sizeof line - 1)
            return sph_fail(err, "%s:%d: the line is too long", path, number);
        int n = split(line, words);
        if (!n) continue;
        struct view_say *say = grow(script);
        if (!say) return sph_fail(err, "%s: no memory for the script", path);
        *say = (struct view_say){.line = number};
        if (parse(path, words, n, say, err)) return -1;
        script->n++;
    }
    return ferror(file) ? sph_fail(err, "%s: cannot be read", path) : 0;
}

int view_script_read(const char *path, struct view_script *script, struct sph_error *err) {
    enum { MOST = 1 << 24 };
    *script = (struct view_script){0};
    FILE *file = sph_input_open(path, MOST, err);
    if (!file) return -1;
    int rc = read_lines(file, path, script, err);
    fclose(file);
    if (rc) view_script_free(script);
    return rc;
}

void view_script_free(struct view_script *script) {
    free(script->list);
    *script = (struct view_script){0};
}
