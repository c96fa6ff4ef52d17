/* tb_load.cpp - `sphaera load` over a pseudo-terminal to rt_uart_bus: registers and memory get it
 * SPDX-License-Identifier: Apache-2.0
 *
 * The tool runs as it would before a board; the bytes of its terminal are the bits of the line,
 * which is silent until a packet is there whole, and waits for nobody's time: clocks go by with
 * packets, not while the tool thinks. A block of registers answers as rt_top would. A wrong bit
 * makes the tool send its packet again; when the line, or a bus, goes wrong for good, the tool must
 * say so; a packet that was left half sent must not hurt the next load. Then packets of any address
 * and length come, at buses that take their time, with a wrong bit in any of their parts, with an
 * end too early, and with resets: what is not whole does nothing.
 */
#include <csignal>
#include <fcntl.h>
#include <map>
#include <poll.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "Vrt_uart_bus.h"
#include "bench.h"
#include "stimulus.h"

extern "C" {
#include "machine/machine.h"
#include "tool/board.h"
#include "validate/validate.h"
}

namespace {

struct Board {
    Vrt_uart_bus &dut;
    bench::Bench<Vrt_uart_bus> &b;
    sph_machine &machine;
    std::map<uint32_t, uint32_t> registers, memory;
    uint32_t last_write = 0;
    /* the byte with a wrong bit, from 1; how many from one to the next, 0: there is no other */
    unsigned busy = 0, bytes = 0, spoilt = 0, again = 0;
    bool slverr = false, deaf = false;
    std::string sent;          /* by the board */
    bool slow = false;         /* handshakes and answers wait */
    std::vector<uint32_t> log; /* address, word and half of each write, while slow */
    uint32_t address = 0, data = 0, strobe = 0, given = 0;
    unsigned have = 0,
             wait = 0; /* 1, 2: address, word of a write are taken; 4: address of a read */
    unsigned out_bit = 0, out_wait = 0, out_byte = 0;

    uint32_t read(uint32_t offset) {
        switch (offset) {
        case SPHAERA_ID:
            return SPHAERA_ID_RESET;
        case SPHAERA_VERSION:
            return SPHAERA_VERSION_RESET;
        case SPHAERA_CORE_PROFILE:
            return (uint32_t)machine.regs[SPH_REG_PROFILE];
        case SPHAERA_CORE_EFFECTS:
            return ~0u;
        case SPHAERA_CORE_PARTS: /* spheres, as much as there can be */
            return SPHAERA_CORE_PARTS_DEPTH | SPHAERA_CORE_PARTS_LIGHTS | SPHAERA_CORE_PARTS_RECT |
                   SPHAERA_CORE_PARTS_SPANS | SPHAERA_CORE_PARTS_CONES;
        case SPHAERA_CORE_BUS:
            return 32u << SPHAERA_CORE_BUS_ADDR_LSB;
        case SPHAERA_STATUS:
            return busy ? busy--, SPHAERA_STATUS_BUSY : 0u;
        default:
            return registers[offset];
        }
    }
    /* The list of the buttons: its writes make the registers that the machine has, then it starts
     * and ends. Its items. */
    uint32_t list(bench::Bench<Vrt_uart_bus> &bench) {
        std::map<uint32_t, uint32_t> made;
        uint32_t at = BOARD_LISTS + 2048, n = 1, last = 0;
        for (; memory[at + 4] != 0xfff && n < BOARD_ITEMS; at += 8, n++)
            made[last = memory[at + 4]] = memory[at];
        bench.expect("header", memory[BOARD_LISTS + 4], (uint32_t)BOARD_MAGIC);
        bench.expect("machines", memory[BOARD_LISTS], 1u);
        bench.expect("the list ends with", last, SPHAERA_CONTROL);
        bench.expect("START", made[SPHAERA_CONTROL], SPHAERA_CONTROL_START);
        for (uint32_t i = 0; i < SPH_N_REGS; i++)
            bench.expect("a register of the list", made[SPHAERA_MACHINE + 4 * i],
                         (uint32_t)machine.regs[i]);
        return n;
    }
    /* Buses that wait: valid and what it goes with stand until they are taken. */
    void slow_clock() {
        bench::Random &r = b.random;
        dut.r_awready = dut.m_awready = r.percent(5);
        dut.r_wready = dut.m_wready = r.percent(5);
        dut.r_arready = r.percent(5);
        const bool aw = (dut.r_awvalid && dut.r_awready) || (dut.m_awvalid && dut.m_awready);
        const bool w = (dut.r_wvalid && dut.r_wready) || (dut.m_wvalid && dut.m_wready);
        const bool ar = dut.r_arvalid && dut.r_arready, memory_too = dut.m_wvalid;
        if (aw || ar) address = dut.address_o;
        if (w) data = dut.data_o, strobe = memory_too ? dut.m_wstrb : 0;
        have |= aw | w << 1 | ar << 2;
        if (aw || w || ar) wait = (unsigned)r.below(100);
        const bool ends = (have == 3 || have == 4) && !wait--;
        b.tick();
        b.cycle = 0;
        const uint32_t noise = (uint32_t)r.next();
        dut.r_bvalid = ends && have == 3 && address >> 31;
        dut.m_bvalid = ends && have == 3 && !(address >> 31);
        dut.r_rvalid = ends && have == 4;
        dut.r_rdata = ends ? given : noise;
        dut.r_bresp = dut.m_bresp = dut.r_rresp = (uint8_t)(ends ? slverr * 2 : noise & 3);
        if (ends && have == 3) log.insert(log.end(), {address, data, strobe});
        if (ends) have = 0;
        hear();
    }
    void clock() {
        if (slow) return slow_clock();
        const bool aw = dut.r_awvalid, ar = dut.r_arvalid, mem = dut.m_awvalid;
        const uint32_t answer = ar ? read(dut.address_o & 0xfff) : 0;
        if (aw) {
            last_write = dut.address_o & 0xfff;
            registers[last_write] = last_write == SPHAERA_ERRORS ? 0 : dut.data_o;
            if (last_write == SPHAERA_CONTROL && dut.data_o & SPHAERA_CONTROL_START) busy = 3;
        }
        if (mem) {
            const uint32_t at = dut.address_o & ~7u;
            if (dut.m_wstrb & 15) memory[at] = dut.data_o;
            if (dut.m_wstrb & 0xf0) memory[at + 4] = dut.data_o;
        }
        b.tick();
        b.cycle = 0;
        dut.r_bvalid = aw;
        dut.r_rvalid = ar;
        dut.r_rdata = answer;
        dut.m_bvalid = mem;
        dut.r_bresp = dut.m_bresp = slverr && !ar ? 2 : 0;
        hear();
    }
    /* The board's line, as a serial port takes it. */
    void hear() {
        if (out_wait) {
            out_wait--;
        } else if (!out_bit) {
            if (dut.tx_o) return;
            out_bit = 1;
            out_wait = DIV + DIV / 2 - 1;
        } else {
            out_byte = out_byte >> 1 | (unsigned)dut.tx_o << 8;
            out_wait = DIV - 1;
            if (++out_bit < 10) return;
            if (out_byte & 256) sent.push_back((char)out_byte);
            out_bit = out_wait = 0; /* the next start may come at once */
        }
    }
    void clocks(unsigned n) {
        while (n--)
            clock();
    }
    void speak(unsigned byte) {
        if (++bytes == spoilt) byte ^= 4, spoilt += again;
        for (unsigned bits = (byte | 256) << 1, i = 0; i < 10; i++, bits >>= 1) {
            dut.rx_i = bits & 1;
            clocks(DIV);
        }
    }
    /* Runs the tool; what it exits with. */
    int load(const char *tool, const char *file) {
        const int master = posix_openpt(O_RDWR | O_NOCTTY);
        if (master < 0 || grantpt(master) || unlockpt(master)) return -1;
        const std::string device = ptsname(master);
        const int held = open(device.c_str(), O_RDWR | O_NOCTTY); /* or reads end at once */
        const pid_t child = fork();
        if (!child) {
            execl(tool, tool, "load", device.c_str(), file, (char *)nullptr);
            _exit(127);
        }
        int status = 0;
        size_t at = 0, size = 0; /* byte of a packet, how many it has */
        while (!waitpid(child, &status, WNOHANG)) {
            struct pollfd ready = {master, POLLIN, 0};
            unsigned char part[64];
            const ssize_t n = poll(&ready, 1, 1) > 0 ? read_some(master, part) : 0;
            for (ssize_t i = 0; i < n; i++) {
                if (at == 0) size = part[i] == 'W' ? 7 : 6;
                if (at == 5 && size == 7) size += 4 * (size_t)part[i];
                speak(part[i]);
                if (++at == size) at = 0, answer(master);
            }
        }
        close(held);
        close(master);
        sent.clear();
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /* What the board says of a packet; of one that did not arrive whole, when that is over. */
    void answer(int master) {
        clocks(100 * DIV);
        if (sent.empty() || sent[0] == 'N') clocks((1u << IDLE) + 100 * DIV);
        if (!deaf && write(master, sent.data(), sent.size()) < 0) b.fail("the line is gone");
        sent.clear();
    }
    template <size_t N> static ssize_t read_some(int fd, unsigned char (&part)[N]) {
        return ::read(fd, part, N);
    }
};

/* ---- packets of any kind ---- */

/* What is wrong with a packet. */
enum { NOTHING, OPERATION, ADDRESS, COUNT, WORD, CHECK, STOPS, RESET, RESET_BUS, KINDS };

typedef std::vector<unsigned> Bytes;

void add(Bytes &bytes, uint32_t word) {
    for (int i = 0; i < 4; i++)
        bytes.push_back(word >> 8 * i & 255);
}

Bytes packet(bool write, uint32_t address, const std::vector<uint32_t> &words) {
    Bytes bytes = {write ? (unsigned)'W' : (unsigned)'R'};
    add(bytes, address);
    if (write) bytes.push_back((unsigned)words.size());
    if (write)
        for (uint32_t word : words)
            add(bytes, word);
    unsigned sum = 0;
    for (unsigned byte : bytes)
        sum += byte;
    bytes.push_back(-sum & 255);
    return bytes;
}

/* Whether these bytes begin with a packet, which a wrong bit can make of them. */
bool whole(const Bytes &bytes) {
    if (bytes.size() < 6 || (bytes[0] != 'W' && bytes[0] != 'R')) return false;
    const size_t size = bytes[0] == 'R' ? 6 : 7 + 4 * (size_t)bytes[5];
    unsigned sum = 0;
    for (size_t i = 0; i < size && i < bytes.size(); i++)
        sum += bytes[i];
    return (bytes[0] == 'R' || bytes[5]) && size <= bytes.size() && !(sum & 255);
}

class Packets {
  public:
    Packets(Board &board, bench::Bench<Vrt_uart_bus> &bench) : board_(board), b(bench) {}
    bench::Stimulus driven;

    /* What the buses get, in order, and the answer, which comes behind theirs. */
    void any(int n) {
        board_.slow = true;
        for (int i = 0; i < n; i++) {
            one(i);
            b.done();
        }
        board_.slverr = false;
    }
    /* The last clock in which a packet goes on, and the first in which it is over. */
    void silence() {
        for (unsigned late = 0; late < 2; late++) {
            const Bytes bytes = packet(false, 0x44332211, {});
            board_.sent.clear();
            board_.speak(bytes[0]);
            board_.clocks((1u << IDLE) - 10 * DIV + late);
            for (size_t i = 1; i < bytes.size(); i++)
                board_.speak(bytes[i]);
            settle();
            b.expect("the answer to a packet that stops", board_.sent[0], late ? 'N' : 'K');
            b.expect("its bytes", (uint64_t)board_.sent.size(), late ? 2u : 5u); /* N of the rest */
        }
        b.done();
    }

  private:
    Board &board_;
    bench::Bench<Vrt_uart_bus> &b;
    uint32_t address_ = 0;
    bench::Points &bits_ = driven.alone("address", 32);
    bench::Points &wrong_ = driven.values(
        "a packet with",
        {"all right", "another operation", "a wrong address", "a wrong count", "a wrong word",
         "a wrong check", "its end too early", "a reset in it", "a reset while a bus is busy"});
    bench::Points &size_ = driven.values("words", {"1", "2", "254", "255"});
    bench::Points &met_ =
        driven.together("packets", {"writes", "reads", "registers", "memory", "a refusal"},
                        {{0, 1}, {1, 3}, {2, 3}});

    void settle() { board_.clocks((1u << IDLE) + 3000); }
    void reset() {
        b.reset(1 + b.random.below(3));
        board_.have = board_.out_bit = board_.out_wait = 0;
        board_.sent.clear();
    }
    void one(int i) {
        bench::Random &r = b.random;
        const bool write = r.percent(70);
        const size_t few = r.percent(4) ? 254 + r.below(2) : 1 + r.below(4);
        unsigned kind = r.percent(40) ? (unsigned)NOTHING : (unsigned)r.below(KINDS);
        if (!write && (kind == COUNT || kind == WORD)) kind = CHECK;
        std::vector<uint32_t> words(write ? few : 0), wanted;
        for (uint32_t &word : words)
            word = (uint32_t)r.next();
        address_ = i < 64 ? address_ ^ 1u << i % 32 : (uint32_t)r.next();
        board_.slverr = r.percent(20);
        board_.given = (uint32_t)r.next();
        board_.log.clear();
        board_.sent.clear();

        Bytes bytes = packet(write, address_, words);
        const unsigned bit = 1u << r.below(8);
        static const size_t places[] = {0, 1, 5, 6};
        if (kind >= OPERATION && kind <= WORD) {
            const size_t at = places[kind - OPERATION];
            bytes[at + (kind == ADDRESS ? r.below(4) : kind == WORD ? r.below(4 * few) : 0)] ^= bit;
        } else if (kind == CHECK) {
            bytes.back() ^= bit;
        } else if (kind == STOPS || kind == RESET) {
            bytes.resize(1 + r.below(bytes.size() - 1));
        }
        const bool good = kind == NOTHING || kind == RESET_BUS;
        if (!good && whole(bytes)) return; /* no check of eight bits notices that */
        bits_.word(address_);
        wrong_.value(kind);
        if (good && write)
            size_.value(few < 3 ? (int64_t)few - 1 : few > 4 ? (int64_t)few - 252 : -1);
        const unsigned where = write && !(address_ >> 31) ? 8u : 4u;
        if (kind == NOTHING) met_.clock((write ? 1u : 2u) | where | (board_.slverr ? 16u : 0u));
        for (unsigned byte : bytes) {
            board_.speak(byte);
            board_.clocks((unsigned)r.below(4));
        }
        if (kind == RESET_BUS)
            for (uint64_t n = r.below(100); n--;)
                board_.clock();
        if (kind >= RESET) {
            reset();
            const std::vector<uint32_t> before = board_.log;
            settle();
            b.expect("words behind a reset", board_.log == before, 1);
            b.expect("answers behind a reset", (uint64_t)board_.sent.size(), 0u);
            return;
        }
        for (size_t k = 0; good && k < words.size() && !(board_.slverr && k); k++) {
            const uint32_t at = address_ + 4 * (uint32_t)k;
            wanted.insert(wanted.end(), {at, words[k], at >> 31 ? 0 : at & 4 ? 0xf0u : 0x0fu});
        }
        settle();
        for (size_t n = good ? few : 0; n > 8; n -= 8) /* the buses take their time */
            board_.clocks(2000);
        b.expect("writes", board_.log == wanted, 1);
        const char answer = !good ? 'N' : board_.slverr ? 'E' : 'K';
        const size_t size = answer == 'K' && !write ? 5 : 1;
        if (b.expect("bytes of the answer", (uint64_t)board_.sent.size(), size)) {
            b.expect("the answer", board_.sent[0], answer);
            for (unsigned k = 1; k < size; k++)
                b.expect("a byte that is read", (unsigned char)board_.sent[k],
                         board_.given >> 8 * (k - 1) & 255);
        }
        if (b.bad()) b.show("address", address_, 32), b.show("what is wrong", kind, 4);
    }
};

/* ---- loads ---- */

/* What arrived is what the file has. */
void same(Board &board, bench::Bench<Vrt_uart_bus> &b) {
    for (uint32_t i = 0; i < board.machine.lines * SPH_LINE_WORDS; i++)
        b.expect("memory", board.memory[4 * i], board.machine.mem[i]);
    for (uint32_t i = 0; i < SPH_N_REGS; i++)
        b.expect("register", board.registers[SPHAERA_MACHINE + 4 * i],
                 (uint32_t)board.machine.regs[i]);
    b.expect("memory words", board.memory.size(),
             board.machine.lines * SPH_LINE_WORDS + 2 + 2 * board.list(b));
    b.expect("started last", board.last_write, SPHAERA_CONTROL);
    b.done();
}

} // namespace

int main(int argc, char **argv) {
    bench::Bench<Vrt_uart_bus> b("tb_load", argc, argv, 5);
    const char *given = getenv("BENCH_BUILD"), *known = getenv("SPHAERA");
    const std::string build = given ? given : "build";
    const std::string tool = known ? known : build + "/sphaera";
    const std::string file = build + "/tb/load.sph";
    const std::string make = tool + " build scenes/paper5.nff --profile draft --size 320x240 " +
                             "--depth 1 -o " + file + " >" + file + ".log 2>&1";
    sph_machine machine{};
    struct sph_error err = {{0}};
    if (system(make.c_str()) || sph_machine_read(file.c_str(), &machine, &err))
        return printf("not ok tb_load: no machine: %s %s\n", make.c_str(), err.text), 1;
    Board board{b.dut, b, machine, {}, {}};
    b.dut.rx_i = b.dut.r_awready = b.dut.r_wready = b.dut.r_arready = 1;
    b.dut.m_awready = b.dut.m_wready = 1;
    b.reset();
    board.clocks(100);
    b.expect("a load", (uint64_t)board.load(tool.c_str(), file.c_str()), 0u);
    same(board, b);
    for (unsigned i = 0; i < 8; i++) { /* each in another place of its packet */
        board.bytes = 0;
        board.spoilt = i < 4 ? 1 + 2 * i : 700 + 3 * i;
        board.registers.clear();
        board.memory.clear();
        b.expect("a load with a wrong bit", (uint64_t)board.load(tool.c_str(), file.c_str()), 0u);
        same(board, b);
    }
    const std::map<uint32_t, uint32_t> right = board.registers, full = board.memory;
    board.bytes = 0;
    board.spoilt = board.again = 5; /* in all packets */
    b.expect("a bad line is told", (uint64_t)board.load(tool.c_str(), file.c_str()), 1u);
    b.expect("registers behind it", board.registers == right, 1);
    b.expect("memory behind it", board.memory == full, 1);
    b.done();
    board.spoilt = 0;
    board.slverr = true;
    b.expect("SLVERR is told", (uint64_t)board.load(tool.c_str(), file.c_str()), 1u);
    b.done();
    board.slverr = false;
    board.deaf = true;
    b.expect("silence is told", (uint64_t)board.load(tool.c_str(), file.c_str()), 1u);
    b.done();
    board.deaf = false;
    board.speak('W');
    board.speak(0x12);
    board.registers.clear();
    board.memory.clear();
    b.expect("a load after half a packet", (uint64_t)board.load(tool.c_str(), file.c_str()), 0u);
    same(board, b);
    Packets packets(board, b);
    packets.any(400);
    packets.silence();
    if (b.all_vectors && !b.mismatches && !packets.driven.whole()) b.fail("the list of stimulus");
    sph_machine_free(&machine);
    return b.finish();
}
