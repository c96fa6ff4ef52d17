/* driven_icarus.h - the core in Icarus, a clock at a time; see host.h, icarus_pins.vh
 * SPDX-License-Identifier: Apache-2.0
 *
 * vvp reads a line of inputs and writes a line of outputs each clock, through two pipes. Unknown
 * bits (x) where an output has a meaning are failures: what is valid, its payload, busy_o,
 * errors_o.
 */
#ifndef TB_DRIVEN_ICARUS_H
#define TB_DRIVEN_ICARUS_H

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "host.h"
#include "words.h"

class DrivenIcarus : public PortHost {
  public:
    DrivenIcarus(const Options &o, const sph_machine &machine, Run &run);
    ~DrivenIcarus() override;
    DrivenIcarus(const DrivenIcarus &) = delete;
    DrivenIcarus &operator=(const DrivenIcarus &) = delete;

  private:
    static const int RESET = 4; /* clocks */
    void step(const Inputs &in, Outputs &out) override;
    void read(const char *text, Outputs &out);
    void complain(const char *what, const char *text);
    bool start(const char *engine);

    FILE *to_ = nullptr, *from_ = nullptr;
    pid_t child_ = -1;
};

inline bool DrivenIcarus::start(const char *engine) {
    int to[2], from[2];
    if (pipe(to)) return false;
    if (pipe(from)) return close(to[0]), close(to[1]), false;
    child_ = fork();
    if (child_ == 0) {
        char in[40], out[40];
        close(to[1]);
        close(from[0]);
        int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, 1);
        dup2(nowhere, 2);
        std::snprintf(in, sizeof in, "+pins=/dev/fd/%d", to[0]);
        std::snprintf(out, sizeof out, "+out=/dev/fd/%d", from[1]);
        execlp("vvp", "vvp", "-n", engine, in, out, static_cast<char *>(nullptr));
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    to_ = fdopen(to[1], "w");
    from_ = fdopen(from[0], "r");
    return child_ > 0 && to_ && from_;
}

inline DrivenIcarus::DrivenIcarus(const Options &o, const sph_machine &machine, Run &run)
    : PortHost(o, machine, run) {
    signal(SIGPIPE, SIG_IGN); /* a dead vvp is told by the line that is missing */
    char head[16] = "";
    unsigned width = 0;
    if (!start(o.engine.c_str()) || !std::fgets(head, sizeof head, from_) ||
        !Words(head).hex(width).good())
        fail(run, "no vvp of '%s'", o.engine.c_str());
    memory().width(width);
    pins.rst = true;
    for (int i = 0; i < RESET; i++)
        clock();
    pins.rst = false;
}

inline DrivenIcarus::~DrivenIcarus() {
    if (to_) fclose(to_);
    if (from_) fclose(from_);
    if (child_ > 0) waitpid(child_, nullptr, 0);
}

inline void DrivenIcarus::complain(const char *what, const char *text) {
    if (!run_.failure[0])
        fail(run_, "clock %" PRIu64 ": %s: %.*s", cycle(), what,
             static_cast<int>(std::strcspn(text, "\n")), text);
}

/* "req rsp pix line tag [pixel] / busy errors count" */
inline void DrivenIcarus::read(const char *text, Outputs &out) {
    const char *behind = std::strstr(text, " / ");
    Words seen(behind ? behind + 3 : "");
    seen.word(); /* busy, below */
    if (!seen.hex(out.seen.errors).good())
        return complain("unknown busy_o or errors_o, or no line", text);
    out.seen.busy = behind[3] == '1';
    out.seen.known = seen.hex(out.seen.count).good();
    out.req_valid = text[0] == '1';
    out.rsp_ready = text[1] == '1';
    out.pix_valid = text[2] == '1';
    const auto known = static_cast<int64_t>(std::strcspn(text, "xzXZ"));
    if (known < (out.req_valid || out.pix_valid ? behind - text : 3) ||
        std::strpbrk("xzXZ", std::string(behind + 3, 1).c_str()))
        return complain("unknown bits", text);
    Words words(text + 4);
    if (out.req_valid && !Words(text + 4).hex(out.req_line).hex(out.req_tag).good())
        return complain("not a line and a tag", text);
    if (!out.pix_valid) return;
    words.word(); /* the line of memory */
    words.word(); /* its tag */
    words.hex(out.x).hex(out.y);
    const std::string hex = words.word();
    if (!words.hex(out.pixel.id)
             .hex(out.pixel.key)
             .hex(out.pixel.visits)
             .hex(out.pixel.texture)
             .hex(out.pix_frame)
             .good() ||
        !hex_digits(hex, 6, out.pixel.colour, SPH_FRAMES))
        return complain("not a pixel", text);
}

inline void DrivenIcarus::step(const Inputs &in, Outputs &out) {
    const bool bits[] = {in.pins.rst,
                         in.pins.start,
                         in.pins.keep_cache,
                         in.pins.cfg_valid,
                         in.memory.request_ready,
                         in.memory.response_valid,
                         in.memory.error,
                         in.pix_ready};
    unsigned control = 0;
    for (bool bit : bits)
        control = control << 1 | bit;
    char text[512] = "";
    if (!to_ || !from_) return;
    const auto &data = in.memory.data;
    std::fprintf(to_, "%x %x %x %x %x ", control, static_cast<unsigned>(in.pins.cfg_addr),
                 in.pins.cfg_data, static_cast<unsigned>(in.pins.count_addr), in.memory.tag);
    for (size_t i = data.size(); i--;)
        std::fprintf(to_, "%016" PRIx64, data[i]);
    std::fprintf(to_, "\n");
    std::fflush(to_);
    if (!std::fgets(text, sizeof text, from_)) return complain("vvp is gone", "");
    if (cycle() == 0) { /* before the first edge of a reset nothing is known */
        out.seen = {false, 0, 0, false};
        return;
    }
    read(text, out);
}

#endif
