/* harness_options.c - command lines of the tool: a word a line, the command first
 * SPDX-License-Identifier: Apache-2.0
 *
 * They are parsed and no more: the linker puts what stands here before glibc's argp, and a command
 * is left where it would begin its work. So nothing is read or written, whatever a line says.
 */
#include <argp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { WORDS = 32, GOOD = 1, WRONG };

int tool_main(int argc, char **argv); /* cmodel/tool/main.c */

error_t __real_argp_parse(const struct argp *argp, int argc, char **argv, unsigned flags,
                          int *index, void *input);
error_t __wrap_argp_parse(const struct argp *argp, int argc, char **argv, unsigned flags,
                          int *index, void *input);
int __wrap_guard_start(void);
void __wrap_argp_error(const struct argp_state *state, const char *format, ...);

int __wrap_guard_start(void) {
    return 0; /* no thread, no limit */
}

/* What argp and commands have is lost where a line is left by longjmp(). */
int __lsan_is_turned_off(void);
int __lsan_is_turned_off(void) {
    return 1;
}

static jmp_buf parsed;
static int depth; /* the tool's own line first, then its command's */

error_t __wrap_argp_parse(const struct argp *argp, int argc, char **argv, unsigned flags,
                          int *index, void *input) {
    error_t bad = __real_argp_parse(argp, argc, argv, flags | ARGP_NO_EXIT, index, input);
    if (bad) longjmp(parsed, WRONG);
    if (depth++) longjmp(parsed, GOOD);
    return 0;
}

void __wrap_argp_error(const struct argp_state *state, const char *format, ...) {
    va_list ap;
    va_start(ap, format);
    fprintf(stderr, "%s: ", state->name);
    vfprintf(stderr, format, ap);
    fputc('\n', stderr);
    va_end(ap);
    longjmp(parsed, WRONG);
}

void fuzz_begin(const char *root) {
    (void)root;
}

/* What was said on the way. */
static void judge(int how, const char *said) {
    if (how == GOOD && *said) fuzz_fail("taken, and yet: %s", said);
    if (how == WRONG && strncmp(said, "sphaera", 7) != 0) fuzz_fail("refused with: %s", said);
}

/* Whether a word is an option, or the first letters of it. */
static int begins(const char *option, const char *word) {
    return strlen(word) > 2 && !strncmp(option, word, strcspn(word, "="));
}

void fuzz_one(const uint8_t *data, size_t size) {
    char *text = malloc(size + 1), *words[WORDS + 2] = {(char *)"sphaera"}, *said = NULL;
    size_t length;
    volatile int n = 1;
    if (!text) exit(2);
    memcpy(text, data, size);
    text[size] = 0;
    for (char *at = text, *end; at && n <= WORDS; at = end) {
        end = strchr(at, '\n');
        if (end) *end++ = 0;
        /* what ends the program by itself */
        int asks = begins("--help", at) || begins("--usage", at) || begins("--version", at) ||
                   (*at == '-' && (strchr(at, 0xff) || (at[1] != '-' && strpbrk(at, "?V"))));
        if (!asks) words[n++] = at;
    }
    FILE *err = stderr, *out = stdout, *to = open_memstream(&said, &length);
    stderr = stdout = to;
    depth = 0;
    int how = setjmp(parsed);
    if (!how) {
        tool_main(n, words);
        how = -1;
    }
    stderr = err;
    stdout = out;
    fclose(to);
    if (how < 0) fuzz_fail("the command ran");
    judge(how, said);
    free(said);
    free(text);
}
