/* signals.h - signals of a verilated core by their names
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_SIGNALS_H
#define TB_SIGNALS_H

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model.h"
#include "verilated.h"
#include "verilated_syms.h"
extern "C" {
#include "math/fx.h"
}

/* A signal as it stands now. One that the core does not show is 0 and has no bits. */
class Shown {
  public:
    Shown() = default;
    explicit Shown(const VerilatedVar *var) {
        if (!var) return;
        data_ = static_cast<const uint8_t *>(var->datap()); /* little endian, whatever its type */
        bits_ = var->packed().elements();
    }
    int bits() const { return bits_; }
    explicit operator bool() const { return data_ != nullptr; }
    /* Bits lsb .. lsb+n-1, n up to 128; unsigned, or two's complement. */
    sph_u128 get(int lsb, int n) const {
        sph_u128 word = 0;
        for (int at = (lsb + n - 1) / 8; data_ && at >= lsb / 8; at--) {
            const int up = 8 * at - lsb;
            word |= up >= 0 ? static_cast<sph_u128>(data_[at]) << up
                            : static_cast<sph_u128>(data_[at] >> -up);
        }
        return n == 128 ? word : word & ((static_cast<sph_u128>(1) << n) - 1);
    }
    sph_i128 number(int lsb, int n) const {
        const int up = 128 - n;
        return static_cast<sph_i128>(get(lsb, n) << up) >> up;
    }
    sph_u128 all() const { return get(0, bits_); }
    sph_i128 number() const { return number(0, bits_); }
    uint32_t word() const { return static_cast<uint32_t>(all()); }
    bool bit(int at = 0) const { return get(at, 1) != 0; }

  private:
    const uint8_t *data_ = nullptr;
    int bits_ = 0;
};

/* A module or a generate block of the core, and of which engine and unit it is a part. */
struct Place {
    const VerilatedScope *scope;
    std::string path;
    Shown operator[](const char *name) const {
        return Shown(scope ? scope->varFind(name) : nullptr);
    }
    /* The number of the innermost g_WHAT[number] around it; -1: there is none. */
    int number(const std::string &what) const {
        const size_t at = path.rfind("." + what + "[");
        uint64_t n = 0;
        if (at == std::string::npos) return -1;
        const char *digits = path.c_str() + at + what.size() + 2;
        return sph_take_count(&digits, 0, UINT8_MAX, &n) ? -1 : static_cast<int>(n);
    }
};

/* Every place of the core that shows a signal of this name. */
class Places {
  public:
    explicit Places(VerilatedContext &context) : context_(context) {}
    std::vector<Place> with(const char *signal) const {
        std::map<std::string, Place> places; /* in the order of their paths */
        for (const auto &scope : *context_.scopeNameMap())
            if (scope.second->varsp() && scope.second->varFind(signal))
                places[scope.first] = {scope.second, scope.first};
        std::vector<Place> list;
        for (const auto &place : places)
            list.push_back(place.second);
        return list;
    }
    Place at(const std::string &path) const {
        const auto &names = *context_.scopeNameMap();
        const auto found = names.find(path.c_str());
        return {found == names.end() ? nullptr : found->second, path};
    }

  private:
    VerilatedContext &context_;
};

#endif
