/* child.cpp - see child.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "child.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>

namespace {

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

/* Waits for the child; tells how long it takes once its speed has been seen. */
void wait_for(const Options &o, pid_t child, Run &run, uint64_t pixels) {
    auto begin = Clock::now();
    bool told = false;
    for (int status = 0; waitpid(child, &status, WNOHANG) != child; usleep(20000)) {
        if (!o.progress || since(begin) < 2) continue;
        double done = static_cast<double>(run.pixels) / static_cast<double>(pixels);
        double total = done > 0 ? since(begin) / done : 0;
        if (!told && total > SECONDS_WORTH_A_WORD)
            std::fprintf(stderr, "simulation takes about %.0f s (%.0f pixels a second)\n", total,
                         static_cast<double>(run.pixels) / since(begin));
        told = told || total > 0;
        if (isatty(2))
            std::fprintf(stderr, "\r%3.0f %% of %llu pixels, %.0f s to go ", 100 * done,
                         static_cast<unsigned long long>(pixels), total - since(begin));
    }
    if (!run.done) fail(run, "the simulating process ended before its frame");
    if (o.progress && isatty(2)) std::fprintf(stderr, "\r%60s\r", "");
}

} // namespace

bool simulate_watched(const Options &o, const sph_machine &machine, Outcome &c,
                      std::string &error) {
    auto begin = Clock::now();
    size_t frame =
        static_cast<size_t>(c.model_frame.width) * static_cast<size_t>(c.model_frame.height);
    for (Sample *&samples : c.samples) {
        samples = static_cast<Sample *>(shared_memory(frame * sizeof(Sample)));
        if (!samples) return error = "no memory for the core's pixels", false;
    }
    void *place = shared_memory(sizeof(Run));
    if (!place) return error = "no memory for the core's counters", false;
    auto *run = new (place) Run{};
    c.run = run;
    run->window = c.window;
    /* the model knows nothing of bus errors, nor of lines that cannot be read */
    const bool known = o.bus_error_at < 0 && (o.spoil < 0 || o.warm);
    run->model = o.stop && known ? &c.model_frame : nullptr;
    run->stages = o.pixel[0] >= 0 ? &c.stages : nullptr;
    if (!o.progress || run->stages) { /* which no other process could fill */
        simulate(o, machine, c.samples, *run);
    } else {
        std::fflush(nullptr);
        pid_t child = fork();
        if (child < 0) return error = "no process to simulate in", false;
        if (child == 0) {
            simulate(o, machine, c.samples, *run);
            run->done = 1;
            std::fflush(nullptr);
            _exit(0);
        }
        wait_for(o, child, *run, c.pixels() * (o.warm ? 2 : 1));
    }
    c.seconds = since(begin);
    return true;
}
