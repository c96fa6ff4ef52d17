# cover.awk - a ground of radius 1000 under 480 spheres of radius 0.2 and three of radius 1
# SPDX-License-Identifier: Apache-2.0
function rnd() { s = s * 16807 % 2147483647; return s / 2147483647 }
BEGIN {
    s = 7
    print "v\nfrom 13 2 3\nat 0 0 0\nup 0 1 0\nangle 20\nhither 0.1\nresolution 320 180"
    print "b 0.6 0.75 1\nl 30 40 20 0.9 0.9 0.9"
    print "f 0.5 0.5 0.5 0.8 0 0 0 1\ns 0 -1000 0 1000"
    for (a = -11; a < 11; a++)
        for (b = -11; b < 11; b++) {
            x = a + 0.9 * rnd()
            z = b + 0.9 * rnd()
            printf "f %.3f %.3f %.3f 0.8 %.2f 0 0 1\n", rnd(), rnd(), rnd(), rnd() < 0.2 ? 0.6 : 0
            y = sqrt(1000.2 * 1000.2 - x * x - z * z) - 1000
            if (++n <= 480) printf "s %.6f %.6f %.6f 0.2\n", x, y, z
        }
    print "f 0.7 0.6 0.5 0.2 0.8 0 0 1\ns 4 1 0 1\ns 0 1 0 1\nf 0.4 0.2 0.1 0.8 0 0 0 1\ns -4 1 0 1"
}
