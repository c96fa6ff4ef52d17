/* gates.c - see gates.h; TABLES is the file that lab/silicon/program.py wrote
 * SPDX-License-Identifier: Apache-2.0
 *
 * A net is a byte. Nets lie in the order
 *
 *     0 | 1 | inputs | states of flip-flops, read registers | inverted states | words | gates
 *                    '--------- next, at an edge ----------'
 *
 * A group is gates of one kind and level: its outputs are neighbours, and it reads what lies before
 * it. Words are what memories show that are read at once.
 */
#include "gates.h"

#include <inttypes.h>
#include <string.h>

struct group { /* gates of one kind: inputs[k * count + i] is input k of gate i */
    void (*kernel)(const uint8_t *net, const uint32_t *inputs, uint8_t *out, uint32_t count);
    uint32_t input, output, count;
};
struct clocked { /* flip-flops: a net that is high, or their clock stands */
    struct group group;
    uint32_t enable;
};
struct port {
    const char *name;
    uint32_t net, bits; /* of table port_nets */
};
/* Of a memory; address, data and enables: of table pins. */
struct access { /* of reads: clocked, or at once */
    uint32_t memory, address, address_bits, data, enable, clocked;
};
struct memory {
    uint32_t words, width, offset, bit, init; /* of bits, and of table inits; ~0: noise */
};

#include TABLES

enum { EVERY = 255 }; /* calls after which a byte of sums is full */

static uint8_t net[NETS], before[NETS], few[NETS], next[STATES + 1], bits[BITS + 1];
static uint32_t shown[READS + 1]; /* last address of what is read at once */
static uint64_t sums[GATES_PHASES][NETS], accesses[GATES_PHASES][READS + WRITES + 1];
static uint64_t enabled[GATES_PHASES][ENABLES + 1], clocks[GATES_PHASES];
static int phase_now = -1, calls;
static uint64_t noise;

static uint8_t random_bit(void) {
    noise ^= noise << 13;
    noise ^= noise >> 7;
    noise ^= noise << 17;
    return noise >> 40 & 1;
}

void gates_start(uint64_t seed) {
    noise = 88172645463325252U ^ seed << 32;
    memset(net, 0, sizeof net);
    net[1] = 1;
    for (uint32_t i = 0; i < STATES; i++)
        net[STATE + i] = random_bit();
    for (uint32_t i = 0; i < INVERTED; i++)
        net[INVERTED_STATE + i] = net[inverted_of[i]] ^ 1;
    for (uint32_t m = 0; m < MEMORIES; m++)
        for (uint32_t i = 0; i < memories[m].words * memories[m].width; i++) {
            const char given = memories[m].init == ~0U ? 'x' : inits[memories[m].init + i];
            bits[memories[m].bit + i] = given == 'x' ? random_bit() : given == '1';
        }
    memset(sums, 0, sizeof sums);
    memset(accesses, 0, sizeof accesses);
    memset(enabled, 0, sizeof enabled);
    memset(clocks, 0, sizeof clocks);
    memset(few, 0, sizeof few);
    phase_now = -1;
    calls = 0;
    gates_settle();
    memcpy(before, net, sizeof net);
}

static const struct port *port_of(const char *name) {
    for (uint32_t i = 0; i < PORTS; i++)
        if (strcmp(ports[i].name, name) == 0) return &ports[i];
    return NULL;
}

size_t gates_bits(const char *port) {
    const struct port *found = port_of(port);
    return found ? found->bits : 0;
}

void gates_set(const char *port, uint64_t value, size_t lsb) {
    const struct port *found = port_of(port);
    for (size_t i = lsb; found && i < found->bits && i < lsb + 64; i++)
        net[port_nets[found->net + i]] = value >> (i - lsb) & 1;
}

uint64_t gates_get(const char *port, size_t lsb) {
    const struct port *found = port_of(port);
    uint64_t value = 0;
    for (size_t i = lsb; found && i < found->bits && i < lsb + 64; i++)
        value |= (uint64_t)net[port_nets[found->net + i]] << (i - lsb);
    return value;
}

static uint32_t address_of(const struct access *a) {
    uint32_t address = 0;
    for (uint32_t i = 0; i < a->address_bits; i++)
        address |= (uint32_t)net[pins[a->address + i]] << i;
    return address - memories[a->memory].offset;
}

/* The word at an address; beyond the last one there is none, and zeros are seen. */
static void look(const struct access *a, uint8_t *out) {
    const struct memory *m = &memories[a->memory];
    const uint32_t address = address_of(a);
    if (address < m->words)
        memcpy(out, &bits[m->bit + address * m->width], m->width);
    else
        memset(out, 0, m->width);
}

void gates_settle(void) {
    for (uint32_t i = 0; i < STEPS; i++) {
        const struct group *g = &groups[steps[i] & ~STEP_READ];
        if (steps[i] & STEP_READ) {
            const struct access *a = &reads[steps[i] & ~STEP_READ];
            look(a, &net[a->data]);
        } else
            g->kernel(net, &inputs[g->input], &net[g->output], g->count);
    }
}

void gates_edge(void) {
    memcpy(next, &net[STATE], STATES);
    for (uint32_t i = 0; i < FLOPS; i++) {
        const struct group *g = &flops[i].group;
        if (net[flops[i].enable]) g->kernel(net, &inputs[g->input], &next[g->output], g->count);
    }
    for (uint32_t i = 0; i < READS; i++)
        if (reads[i].clocked && net[reads[i].enable]) look(&reads[i], &next[reads[i].data - STATE]);
    for (uint32_t i = 0; i < WRITES; i++) {
        const struct access *w = &writes[i];
        const struct memory *m = &memories[w->memory];
        const uint32_t address = address_of(w);
        for (uint32_t k = 0; address < m->words && k < m->width; k++)
            if (net[pins[w->enable + k]])
                bits[m->bit + address * m->width + k] = net[pins[w->data + k]];
    }
    memcpy(&net[STATE], next, STATES);
    for (uint32_t i = 0; i < INVERTED; i++)
        net[INVERTED_STATE + i] = net[inverted_of[i]] ^ 1;
}

static void flush(void) {
    for (uint32_t i = 0; phase_now >= 0 && i < NETS; i++)
        sums[phase_now][i] += few[i];
    memset(few, 0, sizeof few);
    calls = 0;
}

/* A port that is read behind a register is accessed while it is enabled, one that is read at once
 * when its address changes, one that writes while any bit is enabled. */
static void count_accesses(uint64_t *sum) {
    for (uint32_t i = 0; i < READS; i++) {
        const uint32_t address = address_of(&reads[i]);
        sum[i] += reads[i].clocked ? net[reads[i].enable] : address != shown[i];
        shown[i] = address;
    }
    for (uint32_t i = 0; i < WRITES; i++) {
        uint8_t any = 0;
        for (uint32_t k = 0; k < memories[writes[i].memory].width; k++)
            any |= net[pins[writes[i].enable + k]];
        sum[READS + i] += any;
    }
}

void gates_count(int phase) {
    static uint64_t unseen[READS + WRITES + 1];
    if (phase != phase_now || calls == EVERY) flush();
    phase_now = phase;
    calls++;
    for (uint32_t i = 0; i < NETS; i++) {
        few[i] = (uint8_t)(few[i] + (net[i] ^ before[i]));
        before[i] = net[i];
    }
    count_accesses(phase < 0 ? unseen : accesses[phase]);
    if (phase < 0) return;
    clocks[phase]++;
    for (uint32_t i = 0; i < ENABLES; i++)
        enabled[phase][i] += net[enables[i]];
}

void gates_write(FILE *f) {
    flush();
    fprintf(f, "clocks %" PRIu64 " %" PRIu64 "\n", clocks[0], clocks[1]);
    for (uint32_t i = 0; i < NETS; i++)
        fprintf(f, "%" PRIu64 " %" PRIu64 "\n", sums[0][i], sums[1][i]);
    for (uint32_t i = 0; i < READS + WRITES; i++)
        fprintf(f, "%" PRIu64 " %" PRIu64 "\n", accesses[0][i], accesses[1][i]);
    for (uint32_t i = 0; i < ENABLES; i++)
        fprintf(f, "%" PRIu64 " %" PRIu64 "\n", enabled[0][i], enabled[1][i]);
}
