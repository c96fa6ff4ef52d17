/* refuse.cpp - see refuse.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "refuse.h"

#include <climits>
#include <sstream>
#include <vector>

#include "common/number.h"

namespace {

/* Value of a parameter in "SHADOW=1 REFLECT=2 ...". 0 if it is not there, or no number. */
int built_with(const std::string &built, const std::string &parameter) {
    std::istringstream words(built);
    std::string word;
    uint64_t value = 0;
    while (words >> word)
        if (word.compare(0, parameter.size() + 1, parameter + "=") == 0)
            return sph_parse_count(word.c_str() + parameter.size() + 1, 0, INT_MAX, &value)
                       ? 0
                       : static_cast<int>(value);
    return 0;
}

/* What the machine asks for and the core has too little of, as words such as reflect2. */
std::vector<std::string> missing(const sph_machine &m, const std::string &built) {
    std::vector<std::string> result;
    for (int i = 0; i < SPH_PARTS; i++) {
        int asked = sph_part_asked(&m, i);
        if (built_with(built, sph_parts[i].core) >= asked) continue;
        result.push_back(sph_parts[i].word);
        if (sph_parts[i].most > 1) result.back() += std::to_string(asked);
    }
    return result;
}

} // namespace

std::string refusal(const Options &o, const sph_machine &machine, uint32_t errors) {
    static const char *const names[] = {SPH_ERROR_NAMES};
    if (!(errors & REFUSED)) return "";
    auto words = missing(machine, o.built);
    if (!(errors >> SPH_ERROR_MISSING_EFFECT & 1) || words.empty()) {
        std::string text = "refused: the core sets";
        for (int i = 0; i < SPH_ERRORS; i++)
            if (errors & REFUSED & 1u << i) text += std::string(" ") + names[i];
        text += " and gives no pixel";
        if (errors >> SPH_ERROR_WRONG_PROFILE & 1)
            text += std::string("; the machine was built for profile ") +
                    sph_machine_profile(&machine)->name;
        if (errors >> SPH_ERROR_LEFT_OUT & 1)
            text += "; what another camera would show is left out of the machine";
        return text + "\n";
    }
    std::string text = "refused: the machine asks for ";
    for (size_t i = 0; i < words.size(); i++)
        text += (!i ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
    return text + ", the core was built with " + o.core + "\n";
}
