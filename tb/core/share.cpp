/* share.cpp - see share.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "share.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>

namespace {

const int TILE_ROWS = 8;
const double SECONDS_WORTH_A_WORD = 20;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/* Zeroed memory that children share with their parent; lives until the program ends. */
void *shared_memory(size_t bytes) {
    void *p = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return p == MAP_FAILED ? nullptr : p;
}

/* Waits for the children; tells how long it takes once their speed has been seen. */
void wait_for(const Options &o, std::vector<pid_t> &children, const std::vector<Run *> &runs,
              uint64_t pixels) {
    auto begin = Clock::now();
    bool told = false;
    while (!children.empty()) {
        for (size_t i = 0; i < children.size(); i++) {
            int status = 0;
            if (children[i] < 0 || waitpid(children[i], &status, WNOHANG) != children[i]) continue;
            if (!runs[i]->done)
                fail(*runs[i], "the simulating process ended with status 0x%x",
                     static_cast<unsigned>(status));
            children[i] = -1;
        }
        if (std::all_of(children.begin(), children.end(), [](pid_t c) { return c < 0; })) break;
        usleep(20000);
        if (!o.progress || since(begin) < 2) continue;
        double least = 1;
        uint64_t pixels_done = 0;
        for (const Run *run : runs) {
            const Window &w = run->window;
            double all = static_cast<double>(w.x1 - w.x0) * (w.y1 - w.y0) * (o.warm ? 2 : 1);
            least = std::min(least, static_cast<double>(run->pixels) / all);
            pixels_done += run->pixels;
        }
        double total = least > 0 ? since(begin) / least : 0;
        if (!told && total > SECONDS_WORTH_A_WORD)
            std::fprintf(stderr, "simulation takes about %.0f s (%.0f pixels a second)\n", total,
                         static_cast<double>(pixels_done) / since(begin));
        told = told || total > 0;
        if (isatty(2))
            std::fprintf(stderr, "\r%3.0f %% of %llu pixels, %.0f s to go ", 100 * least,
                         static_cast<unsigned long long>(pixels), total - since(begin));
    }
    if (o.progress && isatty(2)) std::fprintf(stderr, "\r%60s\r", "");
}

} // namespace

std::vector<Window> share_out(const sph_frame &model, const Window &w, int parts) {
    const uint64_t fixed = 8; /* a pixel costs something even if it visits no node */
    std::vector<uint64_t> rows;
    uint64_t total = 0;
    for (int y = w.y0; y < w.y1; y++) {
        uint64_t work = 0;
        for (int x = w.x0; x < w.x1; x++)
            work += fixed + model
                                .pixels[static_cast<size_t>(y) * static_cast<size_t>(model.width) +
                                        static_cast<size_t>(x)]
                                .visits;
        rows.push_back(work);
        total += work;
    }
    std::vector<Window> bands;
    uint64_t sum = 0;
    int begin = w.y0;
    for (int y = w.y0; y < w.y1; y++) {
        sum += rows[static_cast<size_t>(y - w.y0)];
        bool edge = (y + 1 - w.y0) % TILE_ROWS == 0;
        auto bands_done = static_cast<uint64_t>(bands.size()) + 1;
        bool full = sum * static_cast<uint64_t>(parts) >= total * bands_done;
        if (y + 1 < w.y1 && !(edge && full)) continue;
        bands.push_back({w.x0, begin, w.x1, y + 1});
        begin = y + 1;
    }
    return bands;
}

bool simulate_shared(const Options &o, const sph_machine &machine, Outcome &c, std::string &error) {
    auto begin = Clock::now();
    auto bands = share_out(c.model_frame, c.window, o.processes);
    size_t frame =
        static_cast<size_t>(c.model_frame.width) * static_cast<size_t>(c.model_frame.height);
    for (Sample *&samples : c.samples) {
        samples = static_cast<Sample *>(shared_memory(frame * sizeof(Sample)));
        if (!samples) return error = "no memory for the core's pixels", false;
    }
    void *place = shared_memory(bands.size() * sizeof(Run));
    if (!place) return error = "no memory for the core's counters", false;
    auto *run = static_cast<Run *>(place);
    std::vector<Run *> runs;
    for (size_t i = 0; i < bands.size(); i++) {
        new (&run[i]) Run{};
        run[i].window = bands[i];
        /* the model knows nothing of bus errors, nor of lines that cannot be read */
        const bool known = o.bus_error_at < 0 && (o.spoil < 0 || o.warm);
        run[i].model = o.stop && known ? &c.model_frame : nullptr;
        runs.push_back(&run[i]);
    }
    if (bands.size() == 1 && !o.progress) {
        simulate(o, machine, c.samples, run[0]);
    } else {
        std::vector<pid_t> children;
        std::fflush(nullptr);
        for (Run *r : runs) {
            pid_t child = fork();
            if (child < 0) return error = "no process to simulate in", false;
            if (child == 0) {
                simulate(o, machine, c.samples, *r);
                r->done = 1;
                std::fflush(nullptr);
                _exit(0);
            }
            children.push_back(child);
        }
        wait_for(o, children, runs, c.pixels());
    }
    for (const Run *r : runs) {
        c.runs.push_back(r);
        for (int pass = 0; pass < PASSES; pass++) {
            c.total[pass].errors |= r->pass[pass].errors;
            for (int i = 0; i < SPH_COUNTERS; i++)
                c.total[pass].count[i] += r->pass[pass].count[i];
            for (int i = 0; i < MEMORY_COUNTS; i++)
                c.total[pass].memory[i] += r->pass[pass].memory[i];
        }
    }
    c.seconds = since(begin);
    return true;
}
