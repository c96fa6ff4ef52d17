/* core.c - registers, memory and parameters of a core that draws a machine: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "machine/export.h"
#include "machine/parts.h"
#include "sphaera/opaque.h"
#include "validate/describe.h"
#include "validate/validate.h"

int sphaera_registers(void) {
    return SPH_N_REGS;
}

/* Those of light l, from the names of light 0. */
#define LIGHT(l)                                                                                   \
    [SPH_REG_LIGHT0_X + SPH_LIGHT_STRIDE * (l)] = "LIGHT" #l "_X", "LIGHT" #l "_Y",                \
                                           "LIGHT" #l "_Z", "LIGHT" #l "_R", "LIGHT" #l "_G",      \
                                           "LIGHT" #l "_B"

const char *sphaera_register_name(int number) {
    static const char *const names[SPH_N_REGS] = {
#define NAMED(name) [SPH_REG_##name] = #name,
        SPH_EACH_REG(NAMED) LIGHT(1), LIGHT(2), LIGHT(3), LIGHT(4), LIGHT(5), LIGHT(6), LIGHT(7)};
    _Static_assert(SPH_MAX_LIGHTS == 8, "a name for each light");
    return number >= 0 && number < SPH_N_REGS ? names[number] : NULL;
}

const int32_t *sphaera_machine_registers(const sphaera_machine *machine) {
    return machine->machine.regs;
}

const uint32_t *sphaera_machine_memory(const sphaera_machine *machine, uint32_t *lines) {
    *lines = machine->machine.lines;
    return machine->machine.mem;
}

int32_t sphaera_machine_register(const sphaera_machine *machine, int number) {
    return number >= 0 && number < SPH_N_REGS ? machine->machine.regs[number] : 0;
}

int sphaera_machine_line(const sphaera_machine *machine, uint32_t line, uint32_t words[8]) {
    _Static_assert(SPH_LINE_WORDS == 8, "a line of the header");
    if (!machine || !words || line >= machine->machine.lines) return -1;
    memcpy(words, sph_line(&machine->machine, line), SPH_LINE_WORDS * sizeof *words);
    return 0;
}

int sphaera_machine_parameter(const sphaera_machine *machine, int number,
                              sphaera_parameter *parameter) {
    if (!machine || !parameter || number < 0) return -1;
    const struct sph_machine *m = &machine->machine;
    const struct sph_profile *p = &m->profile;
    const sphaera_parameter widths[] = {{"W", p->w},   {"WD", p->wd}, {"PQ", p->pq},
                                        {"NG", p->ng}, {"FW", p->fw}, {"PR", p->pr}};
    enum { WIDTHS = sizeof widths / sizeof *widths };
    if (number >= WIDTHS + SPH_PARTS) return -1;
    int part = number - WIDTHS;
    *parameter = part < 0 ? widths[number]
                          : (sphaera_parameter){sph_parts[part].core, sph_part_asked(m, part)};
    return 0;
}

const char *sphaera_machine_core(const sphaera_machine *machine) {
    return machine->core;
}

/* Copies what was given, and looks at it. */
static int fill(struct sph_machine *m, const int32_t *registers, const uint32_t *memory,
                uint32_t lines, const char *name, struct sph_error *err) {
    size_t words = (size_t)lines * SPH_LINE_WORDS;
    memcpy(m->regs, registers, sizeof m->regs);
    m->profile = sph_profile_unpack((uint32_t)registers[SPH_REG_PROFILE]);
    m->lines = lines;
    m->rotation[0] = m->rotation[4] = m->rotation[8] = 1;
    snprintf(m->name, sizeof m->name, "%s", name);
    /* a line more, of zeros: fields are read two words at a time */
    m->mem = calloc(words + SPH_LINE_WORDS, sizeof *m->mem);
    if (!m->mem) return sph_fail(err, "no memory for %u lines", lines);
    if (words) memcpy(m->mem, memory, words * sizeof *m->mem);
    if (!sph_machine_validate(m, err)) return 0;
    sph_machine_free(m);
    return -1;
}

int sphaera_machine_make(const int32_t *registers, int n_registers, const uint32_t *memory,
                         uint32_t lines, const char *name, sphaera_machine **machine,
                         sphaera_error *error) {
    if (sph_api_null(registers, "registers", error) || sph_api_null(memory, "memory", error) ||
        sph_api_null(name, "name", error) || sph_api_null(machine, "machine", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    *machine = NULL;
    if (n_registers != SPH_N_REGS) {
        sph_fail(&err, "n_registers is %d, a machine has %d", n_registers, SPH_N_REGS);
        return sph_api_failed(&err, error);
    }
    sphaera_machine *made = sph_api_machine(&err);
    if (!made || fill(&made->machine, registers, memory, lines, name, &err)) {
        free(made);
        return sph_api_failed(&err, error);
    }
    sph_machine_core(&made->machine, made->core, sizeof made->core);
    *machine = made;
    return 0;
}

int sphaera_machine_export(const sphaera_machine *machine, const char *format, const char *path,
                           sphaera_error *error) {
    static const char *const formats[] = {"hex", "c", NULL};
    if (sph_api_null(machine, "machine", error) || sph_api_null(format, "format", error) ||
        sph_api_null(path, "path", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    int how = sph_api_choice("format", format, formats, &err);
    int rc = how < 0 ? -1
             : how   ? sph_machine_write_c(&machine->machine, path, &err)
                     : sph_machine_write_hex(&machine->machine, path, &err);
    return rc ? sph_api_failed(&err, error) : 0;
}
