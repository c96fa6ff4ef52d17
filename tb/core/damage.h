/* damage.h - machines with random words, and at the end of their limits
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_DAMAGE_H
#define TB_DAMAGE_H

#include <cstdlib>
#include <vector>

#include "events.h"
#include "model.h"
#include "random.h"

/* A machine of its own, with its own memory, and more lines behind it. */
class Copy {
  public:
    explicit Copy(const sph_machine &m, uint32_t more = 0);
    Copy(const Copy &) = delete;
    Copy &operator=(const Copy &) = delete;
    sph_machine machine;

  private:
    std::vector<uint32_t> words_;
};

/* The machine that it was made of with all its lines so many lines further on: a large memory, of
 * which what is not used takes no room. */
class Moved {
  public:
    Moved(const sph_machine &m, uint32_t by);
    ~Moved() { free(machine.mem); }
    Moved(const Moved &) = delete;
    Moved &operator=(const Moved &) = delete;
    sph_machine machine; /* mem is null if there is no such memory */
};

/* What a line of memory holds: TREE_WORDS, RECORD_WORDS or OTHER_WORDS. */
Event kind_of(const sph_machine &m, uint32_t line);

/* Puts random words into one to four lines; no ray visits more than a few nodes of it. What they
 * held. */
std::vector<Event> spoil_words(sph_machine &m, Random &random);

/* Registers with other values, of which each is legal by itself; background by rectangle if `rect`.
 */
void turn_registers(sph_machine &m, Random &random, bool rect);

/* Registers with words of any kind, but window and limits. */
void spoil_registers(sph_machine &m, Random &random);

/* Nodes of spheres in a row below the root, in pairs of lines from `free` on: each has the next one
 * and a node without children below it, so that a ray has `depth` groups on its stack. */
void pile_up(sph_machine &m, uint32_t free, int depth);

#endif
