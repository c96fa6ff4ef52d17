/* report.h - what a run says: counters, one line, JSON
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_REPORT_H
#define TB_REPORT_H

#include <string>

#include "model.h"
#include "options.h"
#include "outcome.h"

/* ---- why a core refuses a machine, in words ---- */

/* A core that sets one of these renders nothing. */
const uint32_t REFUSED =
    1u << SPH_ERROR_MISSING_EFFECT | 1u << SPH_ERROR_WRONG_PROFILE | 1u << SPH_ERROR_LEFT_OUT;

/* One line: what the machine asks for and the core of o.core and o.built does not have; for
 * errors of REFUSED that cannot be explained so, their names. Empty if there is none of them. */
std::string refusal(const Options &o, const sph_machine &machine, uint32_t errors);

/* Table of counters, model beside core (and the warm pass, if there was one), and of
 * the units of the core. */
std::string counter_table(const Options &o, const Outcome &c);

/* What limits each pass, a line each: the unit that works in nearly every clock, or that none does
 * and how much waits. Empty where nobody counts (WorkWatch). */
std::string limits(const Options &o, const Outcome &c);

/* "core SCENE PROFILE WxH: P pixels, M mismatches; cold caches: C cycles, ..." */
std::string summary(const Options &o, const sph_machine &machine, const Outcome &c,
                    const Verdict &v);

/* Writes the report whole or not at all. false with a message. */
bool write_json(const Options &o, const sph_machine &machine, const Outcome &c, const Verdict &v,
                int argc, char **argv, std::string &error);

/* Writes what is asked for: frame files of the core's pixels of the last pass and of the model's,
 * and the clocks of the core's pixels. false with a message. */
bool write_frames(const Options &o, const Outcome &c, std::string &error);

#endif
