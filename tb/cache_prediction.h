/* cache_prediction.h - the model's cache beside an rt_cache: which requests must miss
 * SPDX-License-Identifier: Apache-2.0
 *
 * Sees the handshakes of the RTL's cache clock by clock and tells the model's cache of each lookup
 * and of each group that came, in the order in which the RTL has them. A request is looked up when
 * the RTL's wire `seen` says so, in the order of requests. A group that came counts a clock later.
 */
#ifndef CACHE_PREDICTION_H
#define CACHE_PREDICTION_H

#include <cstdint>
#include <cstdio>
#include <deque>

extern "C" {
#include "machine/layout.h"
#include "memory/cache.h"
}

class CachePrediction {
  public:
    /* LINES, WAYS, GROUP of rt_cache. */
    CachePrediction(uint32_t lines, uint32_t ways, uint32_t group) {
        struct sph_error err = {{0}};
        void_ =
            sph_cache_start(&cache_, lines * SPH_LINE_WORDS, group * SPH_LINE_WORDS, ways, &err);
        if (void_) printf("# %s\n", err.text);
        cache_.late = 1;
    }
    ~CachePrediction() { sph_cache_end(&cache_); }
    CachePrediction(const CachePrediction &) = delete;
    CachePrediction &operator=(const CachePrediction &) = delete;

    /* One clock, with what the ports of rt_cache show before its edge, and its wire `seen`. `apart`
     * marks a request whose miss is counted apart, too. True if a lookup missed: miss_o must be
     * high in the next clock. */
    bool clock(bool valid, bool ready, uint32_t line, bool apart, unsigned seen) {
        const bool forget = seen >> 3 & 1, came = seen >> 2 & 1, error = seen >> 1 & 1;
        const bool looked = seen & 1;
        int missed = 0;
        if (void_) return false;
        if (looked && requests_.empty()) void_ = true;
        if (looked && !void_) {
            missed = sph_cache_ask(&cache_, requests_.front().line * SPH_LINE_WORDS);
            missed_apart_ += missed == 1 && requests_.front().apart;
            if (missed < 0) void_ = true;
            requests_.pop_front();
        }
        if (came_) sph_cache_came(&cache_, error_);
        came_ = came;
        error_ = error;
        if (forget) sph_cache_forget(&cache_);
        if (valid && ready) requests_.push_back({line, apart});
        return missed == 1;
    }
    /* The same for the cache of an rt_texture, by its wire cache_asked; texels are counted apart.
     */
    bool texture(uint32_t asked, unsigned seen) {
        return clock(asked >> 28 & 1, asked >> 27 & 1, asked & 0x3ffffff, asked >> 26 & 1, seen);
    }
    /* All misses, and those that are counted apart. */
    uint64_t missed() const { return cache_.missed; }
    uint64_t missed_apart() const { return missed_apart_; }
    uint64_t asked() const { return cache_.asked; }
    /* The RTL looked something up that the model could not: every line of the set on its way, or no
     * request. */
    bool impossible() const { return void_; }

  private:
    struct Request {
        uint32_t line;
        bool apart;
    };
    struct sph_cache cache_ {};
    std::deque<Request> requests_; /* taken, not looked up yet */
    uint64_t missed_apart_ = 0;
    bool void_, came_ = false, error_ = false;
};

#endif
