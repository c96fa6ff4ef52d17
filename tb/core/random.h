/* random.h - small seeded random numbers, the same on every compiler
 * SPDX-License-Identifier: Apache-2.0
 *
 * splitmix64 (Steele, Lea, Flood 2014): one addition and one mixing function a number.
 */
#ifndef TB_RANDOM_H
#define TB_RANDOM_H

#include <cstdint>

class Random {
  public:
    explicit Random(uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 1) {}

    uint64_t next() {
        uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    /* 0 .. n-1, n >= 1. */
    uint32_t below(uint32_t n) { return static_cast<uint32_t>((next() >> 32) * n >> 32); }

    /* True in `of_100` of 100 calls. */
    bool percent(int of_100) { return of_100 > 0 && static_cast<int>(below(100)) < of_100; }

  private:
    uint64_t state_;
};

#endif
