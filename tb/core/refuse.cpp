/* refuse.cpp - see refuse.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "refuse.h"

#include <cctype>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace {

/* Value of NAME in "SHADOW=1 REFLECT=2 ..."; name in small letters. 0 if it is not there. */
int built_with(const std::string &built, const std::string &name) {
    std::istringstream words(built);
    std::string word, wanted;
    if (name == "bih") return built_with(built, "accel");
    for (char c : name)
        wanted += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    while (words >> word)
        if (word.compare(0, wanted.size() + 1, wanted + "=") == 0)
            return std::atoi(word.c_str() + wanted.size() + 1);
    return 0;
}

/* The words of the machine's list, such as reflect2, for which the core is too small. */
std::vector<std::string> missing(const sph_machine &m, const std::string &built) {
    char list[160];
    sph_machine_core(&m, list, sizeof list);
    std::vector<std::string> result;
    std::istringstream words(list);
    std::string word;
    while (std::getline(words, word, '+')) {
        size_t digits = word.find_first_of("0123456789");
        int count = digits == std::string::npos ? 1 : std::atoi(word.c_str() + digits);
        if (word != "none" && built_with(built, word.substr(0, digits)) < count)
            result.push_back(word);
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
        return text + "\n";
    }
    std::string text = "refused: the machine asks for ";
    for (size_t i = 0; i < words.size(); i++)
        text += (!i ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
    return text + ", the core was built with " + o.core + "\n";
}
