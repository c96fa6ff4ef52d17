/* cmd_load.c - `sphaera load`: a machine file to a board
 * SPDX-License-Identifier: Apache-2.0
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include "tool/board.h"
#include "tool/tool.h"

/* ---- the driver's bus over a serial port; see board.h, and rt_uart_bus.v for packets ---- */

enum {
    REGISTERS = 1u << 31, /* addresses from here on are registers */
    WORDS = 64,           /* the most of a packet */
    WAIT = 3000,          /* ms for an answer */
    TIMES = 4,            /* that a packet is sent, until it arrives whole */
    POLLS = 20000         /* of STATUS, for a frame */
};

/* What is wrong with the line is kept: the driver's bus has no errors, and does nothing after it.
 */
struct link {
    int fd;
    const char *device;
    struct sph_error *err;
    int failed;
};

static void fail(struct link *l, const char *what) {
    if (!l->failed) sph_fail(l->err, "%.200s: %s", l->device, what);
    l->failed = 1;
}

static void take(struct link *l, uint8_t *bytes, size_t n) {
    while (n && !l->failed) {
        struct pollfd ready = {l->fd, POLLIN, 0};
        int rc = poll(&ready, 1, WAIT);
        if (rc < 0 && errno == EINTR) continue;
        ssize_t got = rc > 0 ? read(l->fd, bytes, n) : 0;
        if (rc == 0)
            fail(l, "no answer");
        else if (got <= 0)
            fail(l, "the line is gone");
        else
            bytes += got, n -= (size_t)got;
    }
}

static void put(struct link *l, const uint8_t *bytes, size_t n) {
    for (size_t done = 0; done < n && !l->failed;) {
        ssize_t put = write(l->fd, bytes + done, n - done);
        if (put > 0)
            done += (size_t)put;
        else if (errno != EINTR)
            fail(l, strerror(errno));
    }
}

/* Sends a packet, whose check is added, and takes the answer: a letter, and so many bytes. Of one
 * that did not arrive whole nothing was done: it is sent again. */
static void talk(struct link *l, uint8_t *packet, size_t n, uint8_t *answer, size_t bytes) {
    uint8_t sum = 0, said = 'N';
    for (size_t i = 0; i < n; i++)
        sum = (uint8_t)(sum + packet[i]);
    packet[n++] = (uint8_t)-sum;
    for (int i = 0; i < TIMES && said == 'N' && !l->failed; i++) {
        tcflush(l->fd, TCIFLUSH); /* what noise of a silent line was answered with */
        put(l, packet, n);
        take(l, &said, 1);
    }
    if (!l->failed && said != 'K')
        fail(l, said == 'E'   ? "refused"
                : said == 'N' ? "packets do not arrive whole"
                              : "an answer of another kind");
    take(l, answer, bytes);
}

static void word(uint8_t *to, uint32_t value) {
    for (int i = 0; i < 4; i++)
        to[i] = (uint8_t)(value >> 8 * i);
}

static uint32_t get(void *user, uint32_t offset) {
    uint8_t packet[6] = {'R'}, answer[4] = {0};
    word(packet + 1, REGISTERS | offset);
    talk(user, packet, 5, answer, sizeof answer);
    return answer[0] | (uint32_t)answer[1] << 8 | (uint32_t)answer[2] << 16 |
           (uint32_t)answer[3] << 24;
}

/* Whole words. */
static void send(struct link *l, uint32_t address, const uint8_t *bytes, size_t words) {
    uint8_t packet[7 + 4 * WORDS] = {'W'};
    for (size_t n; words && !l->failed; words -= n) {
        n = words < WORDS ? words : WORDS;
        word(packet + 1, address);
        packet[5] = (uint8_t)n;
        memcpy(packet + 6, bytes, 4 * n);
        talk(l, packet, 6 + 4 * n, NULL, 0);
        address += 4 * (uint32_t)n;
        bytes += 4 * n;
    }
}

static void set(void *user, uint32_t offset, uint32_t value) {
    uint8_t bytes[4];
    word(bytes, value);
    send(user, REGISTERS | offset, bytes, 1);
}

static void write_memory(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
    send(user, (uint32_t)address, bytes, count / 4); /* lines are whole words */
}

static speed_t speed_of(unsigned baud) {
    static const struct {
        unsigned baud;
        speed_t speed;
    } known[] = {{115200, B115200}, {230400, B230400},   {460800, B460800},   {921600, B921600},
                 {500000, B500000}, {1000000, B1000000}, {2000000, B2000000}, {3000000, B3000000}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].baud == baud) return known[i].speed;
    return B0;
}

static int open_line(struct link *l, unsigned baud) {
    struct termios line;
    if (speed_of(baud) == B0)
        return sph_fail(l->err, "%u baud: serial ports have no such speed", baud);
    l->fd = open(l->device, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (l->fd < 0) return sph_fail(l->err, "%.200s: %s", l->device, strerror(errno));
    if (tcgetattr(l->fd, &line)) {
        close(l->fd);
        return sph_fail(l->err, "%.200s: is no serial port", l->device);
    }
    cfmakeraw(&line);
    line.c_cflag |= CLOCAL | CREAD;
    cfsetspeed(&line, speed_of(baud));
    tcsetattr(l->fd, TCSANOW, &line);
    tcflush(l->fd, TCIOFLUSH);
    return 0;
}

int board_load(const struct board_machine *m, int n, const char *device, unsigned baud,
               struct sph_error *err) {
    struct link link = {-1, device, err, 0};
    const struct sphaera_bus bus = {get, set, write_memory, &link};
    struct sphaera s;
    int rc = SPHAERA_OK;
    if (open_line(&link, baud)) return -1;
    int unfit = board_take(&s, &bus, m, n, POLLS, &rc, err);
    uint32_t errors = !unfit && rc == SPHAERA_FAILED ? sphaera_errors(&s) : 0;
    const char *text = sphaera_error_text(&errors);
    close(link.fd);
    if (unfit || link.failed) return -1;
    return rc ? sph_fail(err, "%.200s: %s", device, text ? text : sphaera_text(rc)) : 0;
}

struct arguments {
    const char *names[BOARD_MACHINES + 1], *rom; /* a device before the machine files */
    int n;
    unsigned baud;
};

enum { KEY_ROM = 512, KEY_BAUD };

static const struct argp_option options[] = {
    {"rom", KEY_ROM, "STEM", 0,
     "STEM.registers.hex and STEM.scene.hex, of which `make board` makes a board that draws this "
     "machine alone",
     0},
    {"baud", KEY_BAUD, "N", 0, "bits a second of the serial port (1000000)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case KEY_ROM:
        a->rom = arg;
        return 0;
    case KEY_BAUD:
        a->baud = (unsigned)tool_number(state, "baud", arg, 9600, 4000000);
        return 0;
    case ARGP_KEY_ARG:
        if (a->n == BOARD_MACHINES + 1)
            argp_error(state, "a device and %d files: '%s' is one too many", BOARD_MACHINES, arg);
        a->names[a->n++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (!a->n) argp_error(state, "no machine file given");
        if (a->rom && a->n > 1)
            argp_error(state, "--rom STEM is for one machine: '%s' is one too many", a->names[1]);
        if (!a->rom && a->n < 2)
            argp_error(state, "a serial device before the machine file, or --rom STEM, says "
                              "where to");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int read_all(const struct arguments *a, int device, struct board_machine *machines, int *n,
                    struct sph_error *err) {
    for (int i = device; i < a->n; i++) {
        if (tool_wants_machine(a->names[i], err) ||
            board_machine_read(a->names[i], &machines[*n], err))
            return -1;
        if (board_machine_mode(a->names[i], &machines[(*n)++], err)) return -1;
    }
    return 0;
}

int tool_load_board(int argc, char **argv) {
    static const struct argp argp = {options,
                                     parse,
                                     "[DEVICE] MACHINE.sph...",
                                     "Takes machines to a board: the first one is shown, buttons "
                                     "choose the others.",
                                     NULL,
                                     NULL,
                                     NULL};
    struct arguments a = {.baud = 1000000};
    struct board_machine machines[BOARD_MACHINES];
    struct sph_error err = {""};
    int n = 0;
    tool_parse(&argp, argc, argv, 0, &a);
    int rc = read_all(&a, !a.rom, machines, &n, &err);
    if (!rc)
        rc = a.rom ? board_write_rom(machines, a.rom, &err)
                   : board_load(machines, n, a.names[0], a.baud, &err);
    while (n > 0)
        board_machine_free(&machines[--n]);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
