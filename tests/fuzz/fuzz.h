/* fuzz.h - harnesses that hold what must be true of any input, whatever its bytes
 * SPDX-License-Identifier: Apache-2.0
 *
 * harness_NAME.c defines fuzz_one() for one kind of input; driver.c changes the inputs of a folder
 * by rules of its own and needs no other program, afl.c takes them from AFL++. What is found wrong
 * ends the program by abort(), and the driver then keeps the input.
 */
#ifndef SPH_FUZZ_H
#define SPH_FUZZ_H

#include <stddef.h>
#include <stdint.h>

#include "common/error.h"
#include "machine/machine.h"
#include "scene/scene.h"

/* One input. The working folder is empty but for what this harness left there. */
void fuzz_one(const uint8_t *data, size_t size);

/* Called once before; root: the folder tests/fuzz. */
void fuzz_begin(const char *root);

/* Prints `fuzz: ...` and aborts. */
_Noreturn void fuzz_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The message of a failure: it is there, one line, whole, and starts with `path:`. lines: a line
 * number follows, but for what is wrong with the file as a whole. */
void fuzz_message(const struct sph_error *err, const char *path, int lines);

/* Writes a file into the working folder; nobody else removes or renames it. */
void fuzz_write(const char *name, const uint8_t *data, size_t size);

/* No file has been left by a writer that failed or was done: *.tmp. What is left stays there, so
 * that the first call looks, and then one of 16. */
void fuzz_no_rest(void);

/* The bytes of a file equal these. */
void fuzz_same(const char *name, const uint8_t *data, size_t size);

/* A number that the input decides. */
uint64_t fuzz_hash(const uint8_t *data, size_t size);

/* A scene that was read: written as NFF it is read again as the same text; what the tool's builder
 * makes of it, in a way that `choice` decides, is a valid machine, survives its file, and its tree,
 * its fast form and brute force draw the same; some pixels are those of the naive model. */
void fuzz_scene(const struct sph_scene *scene, uint64_t choice);

/* A valid machine, drawn literally and fast: the same, errors and counters too. */
void fuzz_draw(const struct sph_machine *machine);

#endif
