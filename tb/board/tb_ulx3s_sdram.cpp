/* tb_ulx3s_sdram.cpp - the board of SDRAM, pin to pin: UART and buttons in, pictures out
 * SPDX-License-Identifier: Apache-2.0
 *
 * usage: tb_ulx3s_sdram MACHINE.sph...
 * What `sphaera load` does is done over the bits of the UART's pins; the SDRAM checks the times of
 * its datasheet, and gives its words late: noise between the end of one and tAC of the next, both
 * shifted by the way there and back. The display must see black pictures, then the first machine's;
 * after presses of the buttons those of the others, and no others, with every sync in its place.
 * Frames of 640x480 and 320x240 are shown in 640x480, others in a mode of their own size. Before
 * that, words at addresses of all bits are written, and the board is started anew. The lights tell
 * what goes on; no pin of dq is driven while the part may.
 */
#include "Vulx3s_pins.h"
#include "board_link.h"
#include "sdram_model.h"

extern "C" {
#include "tests/number.h"
#include "tool/board.h"
}

namespace {

/* Steps of 0.8 ns: half a clock of the PLL's oscillator. */
enum { CLOCK = 50, HOLD = 3, ACCESS = 8, ANEW = 1 << 1, NEXT = 1 << 6, BEFORE = 1 << 5 };
enum { SHOWN = 1 << 2, INTERRUPT = 1 << 3 }; /* lights */

class Board {
  public:
    Vulx3s_pins dut;
    Sdram part{16.0};
    std::vector<std::vector<uint32_t>> golden;
    unsigned way = 0; /* steps of the clock to the part and of its words back */
    unsigned blacks = 0, wrong = 0, lost = 0;
    int shown = -1;     /* the machine of the last picture */
    unsigned right = 0; /* pictures of it */
    bool deaf = false;  /* no answer came */
    bool dark = false;  /* a light was wrong */
    bool clash = false; /* a pin was driven that should not be, or the other way round */

    explicit Board(const video::Mode &mode) : mode_(mode), link_(mode) { dut.uart_rx_i = 1; }
    bool sound() const {
        return !wrong && !lost && !deaf && !dark && !clash && !link_.broken &&
               link_.display.error().empty() && part.error().empty();
    }
    void tell() const {
        if (!link_.display.error().empty()) printf("# %s\n", link_.display.error().c_str());
        if (!part.error().empty()) printf("# SDRAM: %s\n", part.error().c_str());
        if (deaf) printf("# the board does not answer\n");
        if (dark) printf("# lights\n");
        if (clash) printf("# pins of the SDRAM are driven by nobody, or by two\n");
    }
    void clocks(uint64_t n) {
        for (n *= CLOCK; n; n--)
            step();
    }
    /* Until two pictures of this machine were seen in a row, or something is wrong. */
    bool see(int machine) {
        const uint64_t most = (uint64_t)mode_.h_total() * mode_.v_total() * FRAMES;
        right = 0;
        for (uint64_t n = 0; n < most && sound() && !(shown == machine && right >= 2); n += 100)
            clocks(100);
        return sound() && shown == machine && right >= 2;
    }
    void press(unsigned button) {
        dut.btn_i |= button;
        clocks(4u << STILL);
        dut.btn_i = dut.btn_i & ~button;
        clocks(4u << STILL);
    }

    void anew() {
        dut.btn_i |= ANEW;
        clocks(8);
        part.restart();
        dut.btn_i = dut.btn_i & ~ANEW;
        clocks(40);
    }

    /* The driver's bus. */
    static uint32_t get(void *user, uint32_t offset) {
        Board &b = *(Board *)user;
        b.packet({'R', (uint8_t)offset, (uint8_t)(offset >> 8), 0, 0x80});
        uint32_t value = 0;
        b.acknowledged();
        for (int i = 0; i < 4; i++)
            value |= b.hear() << 8 * i;
        return value;
    }
    static void set(void *user, uint32_t offset, uint32_t value) {
        uint8_t bytes[4];
        for (int i = 0; i < 4; i++)
            bytes[i] = (uint8_t)(value >> 8 * i);
        put(user, 1u << 31 | offset, bytes, 4);
    }
    static void put(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
        Board &b = *(Board *)user;
        for (uint32_t n; count && !b.deaf; bytes += n, address += n, count -= n) {
            n = count < 256 ? count : 256;
            std::vector<uint8_t> all = {'W'};
            for (int i = 0; i < 4; i++)
                all.push_back((uint8_t)(address >> 8 * i));
            all.push_back((uint8_t)(n / 4));
            all.insert(all.end(), bytes, bytes + n);
            b.packet(all);
            b.acknowledged();
        }
    }

  private:
    static constexpr unsigned FRAMES = 60; /* the most that anything takes */
    video::Mode mode_;
    Link link_;
    uint64_t step_ = 0, edge_ = 0;
    bool part_clk_ = false;
    uint16_t old_ = 0, now_ = 0; /* the part's words: before its last edge, behind it */
    std::vector<bool> heard_;

    void step() {
        dut.clk_25mhz = ++step_ & 1; /* tb/board/EHXPLLL.v */
        const uint64_t since = step_ - edge_ + 100 - way;
        dut.sdram_dq_i = since < 100 + HOLD ? old_ : since < 100 + ACCESS ? (uint16_t)0xdead : now_;
        dut.eval();
        clash = clash || dut.sdram_drives_o != (dut.sdram_oe_o ? 0xffff : 0);
        if (dut.sdram_clk_o != part_clk_) {
            part_clk_ = dut.sdram_clk_o;
            if (part_clk_) edge();
        }
        if (step_ % 5 == 3) link_.bit(dut.gpdi_o);
        while (link_.display.has_picture())
            look(link_.display.picture().rgb);
    }
    void edge() {
        const SdramPins pins = {dut.sdram_cke_o != 0, dut.sdram_command_o, dut.sdram_ba_o,
                                dut.sdram_a_o,        dut.sdram_dqm_o,     dut.sdram_oe_o != 0,
                                dut.sdram_dq_o};
        old_ = now_;
        edge_ = step_;
        part.edge(pins);
        now_ = part.out();
    }
    void look(const std::vector<uint32_t> &rgb) {
        size_t at = 0;
        for (size_t k = 0; k < golden.size(); k++)
            if (rgb == golden[k]) {
                right = shown == (int)k ? right + 1 : 1;
                shown = (int)k;
                return;
            }
        while (at < rgb.size() && !rgb[at])
            at++;
        if (at == rgb.size() && shown < 0) {
            blacks++;
            return;
        }
        wrong++;
        const std::vector<uint32_t> &g = golden[shown < 0 ? 0 : (size_t)shown];
        for (at = 0; at < rgb.size() && rgb[at] == g[at];)
            at++;
        printf("# a picture that is no machine's: pixel %zu of row %zu is %06x, was %06x\n",
               at % mode_.h_active, at / mode_.h_active, rgb[at], g[at]);
    }
    void packet(std::vector<uint8_t> bytes) {
        uint8_t sum = 0;
        for (uint8_t byte : bytes)
            sum = (uint8_t)(sum + byte);
        bytes.push_back((uint8_t)-sum);
        for (unsigned byte : bytes)
            for (unsigned bits = (byte | 256) << 1, i = 0; i < 10 && !deaf; i++, bits >>= 1) {
                dut.uart_rx_i = bits & 1;
                clocks(DIV);
                dark = dark || (dut.led_o >> 1 & 1) == dut.uart_rx_i;
            }
    }
    uint32_t hear() {
        for (uint64_t n = 0; dut.uart_tx_o && !deaf; n++) {
            step();
            deaf = n > 20000 * CLOCK;
        }
        unsigned byte = 0;
        for (uint64_t n = 0; n < CLOCK * DIV / 2; n++) /* the middle of the start bit */
            step();
        for (int i = 0; i < 9; i++) {
            clocks(DIV);
            byte |= (unsigned)dut.uart_tx_o << i;
        }
        deaf = deaf || !(byte & 256);
        for (uint64_t n = 0; n < CLOCK * DIV / 4; n++)
            step();
        return deaf ? 0 : byte & 255;
    }
    void acknowledged() {
        if (hear() != 'K') lost++;
    }
};

/* A mode of a display as small as the frame, which the board need not double. */
void small_mode(board_machine &m) {
    m.mode = {(uint16_t)m.width, 8, 8, 40, (uint16_t)m.height, 4, 4, 8, 0, 0, 0};
}

/* Machines as board_take wants them, and what the display must see of each. */
bool read_all(int n, char **paths, std::vector<board_machine> &machines) {
    struct sph_error err = {{0}}, no_mode;
    for (int i = 0; i < n; i++) {
        board_machine m;
        if (board_machine_read(paths[i], &m, &err)) return fprintf(stderr, "%s\n", err.text), false;
        if (board_machine_mode(paths[i], &m, &no_mode)) small_mode(m);
        machines.push_back(m);
    }
    return true;
}

video::Mode display_of(const sphaera_mode &s) {
    return {s.h_active, s.h_front, s.h_sync, s.h_back, s.v_active,
            s.v_front,  s.v_sync,  s.v_back, s.h_pol,  s.v_pol};
}

/* Around once by the one button, then back by the other: presses, or -1. */
int choose(Board &board, int n) {
    int presses = 0;
    for (int k = 1; k <= n; k++, presses++) {
        board.press(NEXT);
        if (!board.see(k % n)) return -1;
        board.dark = board.dark || board.dut.led_o >> 4 != k % n;
    }
    board.press(BEFORE);
    return board.see(n - 1) ? presses + 1 : -1;
}

/* Each bit of an address counts, set alone and missing alone. */
bool remembers(Board &board) {
    board.clocks(POWER / 2); /* the part begins */
    for (int bit = 3; bit < 25; bit++)
        for (const uint32_t at : {1u << bit, ~(1u << bit) & 0x1fffff8u}) {
            const uint64_t value = 0x9e3779b97f4a7c15u * (at + 1);
            uint8_t bytes[8];
            for (int i = 0; i < 8; i++)
                bytes[i] = (uint8_t)(value >> 8 * i);
            Board::put(&board, at, bytes, 8);
            board.clocks(100);
            if (board.part.word(at >> 10 & 3, at >> 12, (at >> 3 & 127) * 4) != value)
                return printf("# the word of address %07x is another\n", at), false;
        }
    return true;
}

/* The button resets registers. */
bool starts_anew(Board &board) {
    Board::set(&board, SPHAERA_INTERRUPT_ENABLE, 5);
    const bool kept = Board::get(&board, SPHAERA_INTERRUPT_ENABLE) == 5;
    board.anew();
    const bool gone = !Board::get(&board, SPHAERA_INTERRUPT_ENABLE);
    if (!kept || !gone) printf("# registers are not reset by the button alone\n");
    return kept && gone;
}

/* Neither errors nor underruns are told. */
bool untroubled(Board &board, sphaera &driver) {
    uint64_t counters[SPHAERA_COUNTS] = {};
    sphaera_counters(&driver, counters);
    return !sphaera_errors(&driver) && !counters[SPHAERA_COUNT_UNDERRUNS] &&
           (board.dut.led_o & (INTERRUPT | SHOWN)) == SHOWN && board.sound();
}

/* An interrupt that is enabled lights up. */
bool tells(Board &board) {
    Board::set(&board, SPHAERA_INTERRUPT_ENABLE, 15);
    board.dark = board.dark || !(board.dut.led_o & INTERRUPT);
    return board.sound();
}

} // namespace

int main(int argc, char **argv) {
    std::vector<board_machine> machines;
    if (argc < 2) return fprintf(stderr, "usage: tb_ulx3s_sdram MACHINE.sph...\n"), 2;
    if (!read_all(argc - 1, argv + 1, machines)) return 2;
    const int n = (int)machines.size();
    const video::Mode mode = display_of(machines[0].mode);
    Board board(mode);
    for (int i = 1; i < argc; i++)
        board.golden.push_back(golden_picture(argv[i], mode));
    const char *way = getenv("WAY");
    board.way = (unsigned)test_number(way, "WAY", 5); /* 4 ns */

    const sphaera_bus bus = {Board::get, Board::set, Board::put, &board};
    sphaera driver;
    struct sph_error err = {{0}};
    int rc = 0, presses = -1;
    board.clocks(400);
    board.press(NEXT); /* nothing was loaded */
    board.dark = board.dut.led_o & (INTERRUPT | SHOWN);
    const bool ready = remembers(board) && starts_anew(board);
    if (board_take(&driver, &bus, machines.data(), n, 100000, &rc, &err))
        printf("# %s\n", err.text);
    else if (!rc && board.see(0))
        presses = choose(board, n);
    const bool good = ready && presses >= 0 && untroubled(board, driver) && tells(board);
    board.tell();
    board.dut.final();
    const double words = (double)(board.part.commands(4) + board.part.commands(5));
    printf("# SDRAM: %.1f%% of the clocks carry words, %.2f rows opened a burst of four\n",
           400.0 * words / (double)board.part.clocks(), (double)board.part.commands(3) / words);
    printf("%s - tb_ulx3s_sdram: %ux%u, %u black pictures, %d machines loaded, %d presses, each "
           "picture as the golden model has it, %s, lights %02x\n",
           good ? "ok" : "not ok", mode.h_active, mode.v_active, board.blacks, n, presses,
           sphaera_text(rc), board.dut.led_o);
    for (board_machine &m : machines)
        board_machine_free(&m);
    return !good;
}
