/* known_table.h - generated from docs/results/data by `python3 -m lab known`; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
/* profile, effects, pipes, LUT4eq, MULT18X18D, DP16KD, worst, median, best MHz, seeds */
#define SPH_KNOWN_CORES \
    {"draft", "shadow+reflect2+lights3+inside", 1, 14179, 64, 91, 133.2, 133.2, 133.2, 1}, \
    {"fine", "shadow+reflect2+lights3+inside", 1, 19016, 64, 99, 124.2, 124.2, 124.2, 1}, \
    {"reference", "shadow+reflect2+lights3+inside", 1, 20594, 64, 109, 123.3, 123.3, 123.3, 1}, \
    {"standard", "bih", 1, 11193, 20, 67, 0, 0, 0, 0}, \
    {"standard", "facets+boxes", 1, 24795, 66, 61, 0, 0, 0, 0}, \
    {"standard", "inside", 1, 12262, 55, 57, 0, 0, 0, 0}, \
    {"standard", "inside+first+interpenetrate", 1, 15213, 58, 81, 0, 0, 0, 0}, \
    {"standard", "lights1+specular+sum", 1, 17407, 63, 95, 0, 0, 0, 0}, \
    {"standard", "lights2", 1, 14594, 59, 77, 0, 0, 0, 0}, \
    {"standard", "lights2+inside", 1, 14823, 59, 78, 0, 0, 0, 0}, \
    {"standard", "lights2+inside+first+interpenetrate", 1, 15907, 61, 93, 0, 0, 0, 0}, \
    {"standard", "none", 1, 12105, 55, 57, 0, 0, 0, 0}, \
    {"standard", "reflect2", 1, 15638, 61, 82, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside", 1, 15911, 61, 83, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside+first+interpenetrate", 1, 16166, 61, 86, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside+refract+sum", 1, 20084, 66, 99, 0, 0, 0, 0}, \
    {"standard", "reflect2+lights1", 1, 16317, 64, 93, 0, 0, 0, 0}, \
    {"standard", "reflect2+lights2", 1, 16362, 64, 94, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1", 1, 14920, 59, 79, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+clear", 1, 14925, 59, 79, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+facets+smooth+boxes", 1, 30407, 71, 90, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+inside", 1, 15205, 59, 80, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+inside+first+interpenetrate", 1, 16115, 61, 92, 0, 0, 0, 0}, \
    {"standard", "shadow+lights2", 1, 14914, 59, 80, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1", 1, 16622, 64, 93, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside", 1, 16846, 64, 94, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside+facets+refract+specular+sum", 1, 26378, 91, 122, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside+facets+texture+spread", 1, 31978, 100, 136, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2", 1, 16656, 64, 94, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+facets", 1, 21062, 84, 95, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside", 1, 16920, 64, 95, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets", 1, 21286, 84, 95, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets+refract+specular+sum", 1, 26303, 91, 123, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets+texture+spread", 1, 31928, 100, 137, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside", 1, 16164, 64, 95, 122.7, 127.5, 133.5, 5}, \
    {"standard", "shadow+reflect2+lights3+inside+bih", 1, 0, 0, 0, 77.2, 77.2, 77.2, 1}, \
    {"standard", "shadow+reflect2+lights3+inside+facets", 1, 0, 0, 0, 105.3, 105.3, 105.3, 1}, \
    {"standard", "shadow+reflect2+lights3+inside+refract", 1, 0, 0, 0, 113.0, 113.0, 113.0, 1}, \
    {"standard", "shadow+reflect2+lights3+inside+texture", 1, 0, 0, 0, 108.4, 108.4, 108.4, 1}, \
    {"standard", "shadow+reflect2+lights8+inside", 1, 16940, 64, 95, 0, 0, 0, 0}, \
    {"standard", "sum", 1, 13387, 57, 64, 0, 0, 0, 0}, \
    {"standard", "texture", 1, 24566, 72, 106, 0, 0, 0, 0}
