/* refuse.h - why a core refuses a machine, in words
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_REFUSE_H
#define TB_REFUSE_H

#include <string>

#include "model.h"
#include "options.h"

/* A core that sets one of these renders nothing. */
const uint32_t REFUSED =
    1u << SPH_ERROR_MISSING_EFFECT | 1u << SPH_ERROR_WRONG_PROFILE | 1u << SPH_ERROR_LEFT_OUT;

/* One line: what the machine asks for and the core of o.core and o.built does not have; for
 * errors of REFUSED that cannot be explained so, their names. Empty if there is none of them. */
std::string refusal(const Options &o, const sph_machine &machine, uint32_t errors);

#endif
