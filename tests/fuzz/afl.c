/* afl.c - the harness as AFL++ runs it: many inputs a process, through shared memory
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: FUZZ_TMP=FOLDER afl-fuzz ... PROGRAM ROOT     ROOT: the folder tests/fuzz
 */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "common/parallel.h"
#include "fuzz.h"

enum { ROUNDS = 20000 };

__AFL_FUZZ_INIT();

int main(int argc, char **argv) {
    const char *tmp = getenv("FUZZ_TMP");
    if (argc != 2 || !tmp) {
        fputs("usage: FUZZ_TMP=FOLDER afl-fuzz ... PROGRAM ROOT\n", stderr);
        return 2;
    }
    char *root = realpath(argv[1], NULL);
    if (!root || chdir(tmp)) return 2;
    fuzz_begin(root);
    sph_parallel_most(1);
    __AFL_INIT();
    const unsigned char *bytes = __AFL_FUZZ_TESTCASE_BUF;
    while (__AFL_LOOP(ROUNDS))
        fuzz_one(bytes, (size_t)__AFL_FUZZ_TESTCASE_LEN);
    return 0;
}
