/* trials_machine.cpp - see trials.h: trials of other registers and other memory
 * SPDX-License-Identifier: Apache-2.0
 */
#include "damage.h"
#include "report.h"
#include "trials.h"

namespace {

/* Sizes of a core that was given none. */
#define SIZE_OF(NAME, standard) SIZE_##NAME = (standard),
enum : uint32_t { SPH_EACH_SIZE(SIZE_OF) };
#undef SIZE_OF

} // namespace

void Trials::refused() {
    const uint32_t effect = 1u << SPH_ERROR_MISSING_EFFECT, profile = 1u << SPH_ERROR_WRONG_PROFILE;
    Copy other(*now_->scene->machine);
    int32_t *r = other.machine.regs;
    uint32_t errors = 0;
    if (random_.percent(50)) { /* errors of a frame before are forgotten */
        Copy ends(*now_->scene->machine);
        ends.machine.regs[SPH_REG_VISIT_LIMIT] = 0;
        as_model(ends.machine, "no visit");
        met(REFUSED_ERROR);
    }
    if (random_.percent(60)) {
        const int32_t before = r[SPH_REG_TREE];
        switch (random_.below(5)) {
        case 0:
            r[SPH_REG_EFFECTS] |=
                static_cast<int32_t>(1u << (SPH_PARTS + random_.below(32 - SPH_PARTS)));
            break;
        case 1:
            r[SPH_REG_MAX_DEPTH] = SPH_MAX_DEPTH + 1 + pick(15 - SPH_MAX_DEPTH); /* 4 bits */
            break;
        case 2:
            r[SPH_REG_N_LIGHTS] = 9 + pick(7);
            break;
        case 3: /* more memory than lines of the core have numbers */
            r[SPH_REG_MEM_LINES] |=
                1 << (SIZE_LINE_BITS + random_.below(SPH_LINE_BITS - SIZE_LINE_BITS));
            break;
        default:
            r[SPH_REG_TREE] = sph_tree_bih(before) ? SPH_TREE_BOX4 : SPH_TREE_BIH;
        }
        errors |= effect;
        met(REFUSED_EFFECT);
    }
    if (!errors || random_.percent(30)) {
        r[SPH_REG_PROFILE] ^= static_cast<int32_t>(1u << random_.below(32));
        errors |= profile;
        met(REFUSED_PROFILE);
    }
    if (o_.built.find("CAMERA=1") != std::string::npos && random_.percent(40)) {
        r[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_CAMERA;
        r[SPH_REG_ONE_CAMERA] = sph_camera_sum(&other.machine);
        r[random_.percent(30) ? SPH_REG_ONE_CAMERA : SPH_REG_EYE_X + pick(7)] ^= 1 << pick(12);
        errors |= 1u << SPH_ERROR_LEFT_OUT;
        met(REFUSED_CAMERA);
    }
    memory(other.machine);
    player_.refuses(errors, "a machine to be refused");
    memory(*now_->scene->machine);
    clean("a machine that was refused", true);
}

void Trials::windows() {
    Copy other(*now_->scene->machine);
    int32_t *r = other.machine.regs;
    const bool one = random_.percent(50);
    r[SPH_REG_WIN_X0] = pick(r[SPH_REG_FRAME_W]);
    r[SPH_REG_WIN_Y0] = pick(r[SPH_REG_FRAME_H]);
    r[SPH_REG_WIN_X1] = r[SPH_REG_WIN_X0] + one;
    r[SPH_REG_WIN_Y1] = r[SPH_REG_WIN_Y0] + (one || random_.percent(50));
    as_model(other.machine, "a small window");
    met(one ? ONE_PIXEL : EMPTY);
    memory(*now_->scene->machine);
    clean("a small window", false);
}

void Trials::words() {
    Copy other(*now_->scene->machine);
    for (Event e : spoil_words(other.machine, random_))
        met(e);
    as_model(other.machine, "random words in memory");
    memory(*now_->scene->machine);
    clean("random words in memory", false);
}

void Trials::registers() {
    Copy other(*now_->scene->machine);
    turn_registers(other.machine, random_, o_.built.find("RECT=1") != std::string::npos);
    as_model(other.machine, "random legal registers");
    met(REGISTERS);
    memory(*now_->scene->machine);
    clean("random legal registers", false);
}

void Trials::register_words() {
    Copy other(*now_->scene->machine);
    spoil_registers(other.machine, random_);
    memory(other.machine);
    player_.ends(other.machine, now_->scene->window, "random words in registers", {});
    met(REGISTER_WORDS);
    cached_ = nullptr;
    memory(*now_->scene->machine);
    clean("random words in registers", false);
}

void Trials::moved() {
    const uint32_t bits = 1 + random_.below(SIZE_LINE_BITS - 1);
    const Moved other(*now_->scene->machine, random_.below(1u << bits));
    if (!other.machine.mem) return;
    as_model(other.machine, "a machine further on in memory");
    met(MOVED);
    memory(*now_->scene->machine);
    clean("a machine further on in memory", false);
}

void Trials::memory_ends() {
    Copy other(*now_->scene->machine);
    int32_t &lines = other.machine.regs[SPH_REG_MEM_LINES];
    const uint32_t errors = now_->scene->errors;
    while (lines > 1) {
        lines--;
        if (errors_of(other.machine) != errors) break;
    }
    as_model(other.machine, "memory one line too short");
    met(MEMORY_SHORT);
    lines++;
    as_model(other.machine, "memory that is just enough");
    met(MEMORY_FULL);
    memory(*now_->scene->machine);
    clean("memory that is just enough", false);
}

void Trials::visits_end() {
    Copy other(*now_->scene->machine);
    int32_t &limit = other.machine.regs[SPH_REG_VISIT_LIMIT];
    if (random_.percent(30)) {
        limit = random_.percent(50) ? 1 << 23 : (1 << 23) + pick(1 << 23);
        met(VISITS_MANY);
        as_model(other.machine, "2^23 visits and more");
    } else {
        int low = 0, high = limit; /* the fewest without an error */
        while (low < high) {
            limit = low + (high - low) / 2;
            if (errors_of(other.machine) == now_->scene->errors)
                high = limit;
            else
                low = limit + 1;
        }
        limit = high;
        as_model(other.machine, "visits that are just enough");
        met(VISITS_FULL);
        if (--limit >= 0) {
            as_model(other.machine, "one visit too few");
            met(VISITS_SHORT);
        }
    }
    memory(*now_->scene->machine);
    clean("a limit of visits", false);
}

void Trials::stack_ends() {
    const sph_machine &m = *now_->scene->machine;
    if (sph_machine_bih(&m) || m.regs[SPH_REG_TREE] == SPH_TREE_BOX4) return;
    const int full = SPH_STACK_DEPTH + 1; /* one group is at hand */
    for (int depth = full; depth <= full + 1; depth++) {
        Copy other(m, 2 * SPH_STACK_DEPTH + 6);
        pile_up(other.machine, m.lines, depth);
        as_model(other.machine, "a stack that is full");
        const bool over = errors_of(other.machine) >> SPH_ERROR_STACK_OVERFLOW & 1;
        met(over ? STACK_SHORT : STACK_FULL);
    }
    memory(m);
    clean("a stack that is full", false);
}
