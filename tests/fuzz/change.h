/* change.h - inputs made of others, by numbers that a seed decides
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FUZZ_CHANGE_H
#define SPH_FUZZ_CHANGE_H

#include <stddef.h>
#include <stdint.h>

enum { FUZZ_SIZE = 65536 }; /* bytes of the longest input */

struct fuzz_bytes {
    uint8_t *at;
    size_t size;
};

/* Inputs to begin with, and words that the format knows. */
struct fuzz_corpus {
    struct fuzz_bytes *input, *word;
    size_t inputs, words;
};

/* Adds a file, or the files of a folder, to the inputs. Ends the program if it cannot be read. */
void fuzz_add(struct fuzz_corpus *corpus, const char *path);

/* Adds the words of a dictionary of AFL++: lines of name="text", with \xNN, \\ and \". */
void fuzz_add_words(struct fuzz_corpus *corpus, const char *path);

void fuzz_corpus_free(struct fuzz_corpus *corpus);

/* One input of the corpus, changed in one to eight places, to `to` of FUZZ_SIZE bytes; its size. */
size_t fuzz_change(const struct fuzz_corpus *corpus, uint64_t *random, uint8_t *to);

#endif
