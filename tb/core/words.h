/* words.h - what a bench in Icarus writes, word by word
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_WORDS_H
#define TB_WORDS_H

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "common/number.h"

/* Takes words off a line; once one is not as it should be, all are missing. */
class Words {
  public:
    explicit Words(const char *text) : at_(text) {}

    /* The next word, up to a blank; empty at the end. */
    std::string word() {
        at_ += std::strspn(at_, " \n");
        const std::string taken(at_, std::strcspn(at_, " \n"));
        at_ += taken.size();
        if (taken.empty()) good_ = false;
        return taken;
    }

    /* The next word as a hexadecimal number that its type holds. */
    template <class T> Words &hex(T &to) {
        uint64_t value = 0;
        if (sph_parse_hex(word().c_str(), std::numeric_limits<T>::max(), &value)) good_ = false;
        if (good_) to = static_cast<T>(value);
        return *this;
    }

    bool good() const { return good_; }

  private:
    const char *at_;
    bool good_ = true;
};

/* `size` numbers of so many hexadecimal digits each, one behind the other, the last one first:
 * whether the word has these and no more. */
inline bool hex_digits(const std::string &word, size_t digits, uint32_t *to, size_t size) {
    uint64_t value = 0;
    for (size_t i = 0; i < size && word.size() == size * digits; i++) {
        const std::string part = word.substr((size - 1 - i) * digits, digits);
        if (sph_parse_hex(part.c_str(), UINT32_MAX, &value)) return false;
        to[i] = static_cast<uint32_t>(value);
    }
    return word.size() == size * digits;
}

#endif
