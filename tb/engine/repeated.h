/* repeated.h - memory at all addresses: lines that are ALIKE apart are the same
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REPEATED_H
#define SPH_REPEATED_H

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" {
#include "machine/layout.h"
}

namespace world {

class Repeated {
  public:
    static constexpr int PART_BITS = SPH_LINE_BITS - 15; /* of the number of a part */
    static constexpr uint32_t ALIKE = 1u << (SPH_LINE_BITS - PART_BITS);
    static constexpr uint32_t MOST = (1u << SPH_LINE_BITS) - 1; /* as MEM_LINES may say */
    uint32_t *words;                                            /* at first all 0 */

    Repeated() {
        int file = memfd_create("memory", 0);
        void *all =
            mmap(nullptr, ALL, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (file < 0 || ftruncate(file, PART) || all == MAP_FAILED) stop();
        for (size_t at = 0; at < ALL; at += PART)
            if (mmap((char *)all + at, PART, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file,
                     0) == MAP_FAILED)
                stop();
        close(file);
        words = (uint32_t *)all;
    }
    ~Repeated() { munmap(words, ALL); }
    Repeated(const Repeated &) = delete;
    Repeated &operator=(const Repeated &) = delete;

  private:
    static constexpr size_t PART = (size_t)ALIKE * SPH_LINE_WORDS * 4;
    static constexpr size_t ALL = PART << PART_BITS;

    [[noreturn]] static void stop() {
        perror("# memory at all addresses");
        exit(1);
    }
};

} // namespace world

#endif
