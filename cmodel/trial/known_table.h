/* known_table.h - generated from docs/results/data by `python3 -m lab known`; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
/* profile, effects, pipes, LUT4eq, MULT18X18D, DP16KD, worst, median, best MHz, seeds */
#define SPH_KNOWN_CORES \
    {"draft", "shadow+reflect2+lights3+inside", 1, 14728, 64, 91, 133.2, 133.2, 133.2, 1, 0, 0}, \
    {"fine", "shadow+lights1+facets+camera", 1, 22531, 89, 82, 0, 0, 0, 0, 0, 0}, \
    {"fine", "shadow+lights2+facets", 1, 22517, 89, 83, 0, 0, 0, 0, 0, 0}, \
    {"fine", "shadow+reflect2+lights3+inside", 1, 19589, 64, 99, 124.2, 124.2, 124.2, 1, 0, 0}, \
    {"reference", "shadow+reflect2+lights1+inside+facets+texture+spread", 1, 35118, 111, 154, 0, 0, 0, 0, 0, 0}, \
    {"reference", "shadow+reflect2+lights3+inside", 1, 20571, 64, 109, 123.3, 123.3, 123.3, 1, 0, 0}, \
    {"standard", "bih", 1, 11193, 20, 67, 0, 0, 0, 0, 0, 0}, \
    {"standard", "facets+boxes", 1, 24795, 66, 61, 0, 0, 0, 0, 0, 0}, \
    {"standard", "inside", 1, 12262, 55, 57, 0, 0, 0, 0, 0, 0}, \
    {"standard", "inside+first+interpenetrate", 1, 15213, 58, 81, 0, 0, 0, 0, 0, 0}, \
    {"standard", "lights1+camera", 1, 13912, 59, 76, 0, 0, 0, 0, 0, 0}, \
    {"standard", "lights1+specular+sum", 1, 17407, 63, 95, 0, 0, 0, 0, 0, 0}, \
    {"standard", "lights2", 1, 14594, 59, 77, 0, 0, 0, 0, 0, 0}, \
    {"standard", "lights2+inside", 1, 14823, 59, 78, 0, 0, 0, 0, 0, 0}, \
    {"standard", "lights2+inside+first+interpenetrate", 1, 15907, 61, 93, 0, 0, 0, 0, 0, 0}, \
    {"standard", "none", 1, 12105, 55, 57, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2", 1, 15638, 61, 82, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside", 1, 15911, 61, 83, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside+first+interpenetrate", 1, 16166, 61, 86, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2+inside+refract+sum", 1, 20084, 66, 99, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2+lights1", 1, 16317, 64, 93, 0, 0, 0, 0, 0, 0}, \
    {"standard", "reflect2+lights2", 1, 16362, 64, 94, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1", 1, 14920, 59, 79, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+clear", 1, 14925, 59, 79, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+facets+smooth+boxes", 1, 30407, 71, 90, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+inside", 1, 15205, 59, 80, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights1+inside+first+interpenetrate", 1, 16115, 61, 92, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+lights2", 1, 14914, 59, 80, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1", 1, 16622, 64, 93, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside", 1, 16846, 64, 94, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside+facets+refract+specular+sum", 1, 25471, 91, 122, 116.5, 116.5, 116.5, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside+facets+texture+spread", 1, 28509, 98, 136, 109.8, 109.8, 109.8, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights1+inside+refract+specular+sum", 1, 21287, 71, 122, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2", 1, 16656, 64, 94, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+facets", 1, 21062, 84, 95, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside", 1, 16920, 64, 95, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets", 1, 21286, 84, 95, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets+refract+specular+sum", 1, 26303, 91, 123, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets+texture+spread", 1, 31928, 100, 137, 0, 0, 0, 0, 0, 0}, \
    {"standard", "shadow+reflect2+lights2+inside+facets+turned+boxes", 1, 28623, 78, 100, 99.2, 99.2, 99.2, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside", 1, 16176, 64, 95, 122.7, 127.5, 133.5, 5, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside+bih", 1, 0, 0, 0, 77.2, 77.2, 77.2, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside+facets", 1, 0, 0, 0, 105.3, 105.3, 105.3, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside+refract", 1, 0, 0, 0, 113.0, 113.0, 113.0, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights3+inside+texture", 1, 0, 0, 0, 108.4, 108.4, 108.4, 1, 0, 0}, \
    {"standard", "shadow+reflect2+lights8+inside", 1, 16940, 64, 95, 0, 0, 0, 0, 0, 0}, \
    {"standard", "sum", 1, 13387, 57, 64, 0, 0, 0, 0, 0, 0}, \
    {"standard", "texture", 1, 24566, 72, 106, 0, 0, 0, 0, 0, 0}
/* word, what it adds to a core of profile standard: LUT4eq, MULT, DP16KD; points */
#define SPH_KNOWN_WORDS \
    {"bih", -912, -35, 10, 0}, \
    {"boxes", 8274, -9, 4, 0}, \
    {"camera", 14, 0, -1, 0}, \
    {"clear", 8, 0, 0, 0}, \
    {"cones", 1367, 0, 0, 0}, \
    {"facets", 4416, 20, 0, 0}, \
    {"first", 185, 0, 3, 0}, \
    {"inside", 252, 0, 1, 0}, \
    {"interpenetrate", 220, 0, 3, 1}, \
    {"lights", 694, 3, 12, 1}, \
    {"points", 1842, 1, 10, 0}, \
    {"rect", 93, 0, 0, 0}, \
    {"reflect", 1715, 5, 15, 1}, \
    {"refract", 2891, 3, 9, 1}, \
    {"shadow", 312, 0, 0, 0}, \
    {"smooth", 2797, 1, 6, 0}, \
    {"spans", 450, 0, 0, 0}, \
    {"specular", 1531, 2, 11, 0}, \
    {"spread", 13, 0, 2, 0}, \
    {"sum", 1282, 2, 7, 0}, \
    {"texture", 10654, 16, 40, 1}, \
    {"turned", -243, 3, 1, 0}
/* counter, nJ of an event in profile standard; what it is of; the tree of its cores */
#define SPH_KNOWN_EVENTS \
    {SPH_COUNT_NODE_VISITS, 6.2682, "node visit", "spheres"}, \
    {SPH_COUNT_NODE_VISITS, 5.3236, "box visit", "boxes"}, \
    {SPH_COUNT_LEAF_TESTS, 2.0233, "sphere test", ""}, \
    {SPH_COUNT_FACET_TESTS, 4.7946, "triangle test", ""}, \
    {SPH_COUNT_RAYS_PRIMARY, 2.9631, "primary ray", ""}, \
    {SPH_COUNT_RAYS_SHADOW, 6.5430, "shadow ray", ""}, \
    {SPH_COUNT_RAYS_REFLECTED, 16.8795, "reflected ray", ""}
/* profile, what its events take of that; nJ a clock and LUT4eq; with triangles */
#define SPH_KNOWN_PROFILE_ENERGIES \
    {"draft", 0.947, 3.26e-05, 0}, \
    {"reference", 1.024, 0.0001323, 0}, \
    {"standard", 1.000, 3.1e-05, 0.0001272}
/* words of the cores whose energies these are */
#define SPH_KNOWN_ENERGY_WORDS \
    "boxes", \
    "camera", \
    "facets", \
    "inside", \
    "lights", \
    "none", \
    "reflect", \
    "shadow", \
    "turned"
