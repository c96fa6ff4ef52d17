/* sdram_times.h - times of a 256 Mbit SDRAM, as its datasheet has them
 * SPDX-License-Identifier: Apache-2.0
 *
 * Micron MT48LC16M16A2, grade 75 (133 MHz): 4 banks of 8192 rows of 512 columns of 16 bits, the
 * slowest that a ULX3S has had. Nanoseconds.
 */
#ifndef TB_SDRAM_TIMES_H
#define TB_SDRAM_TIMES_H

struct SdramTimes {
    static constexpr double T_RCD = 20, T_RP = 20, T_RAS = 44, T_RC = 66, T_RFC = 66, T_RRD = 15,
                            T_WR = 15, T_RAS_MOST = 120000, T_REF = 64000000, T_POWER = 100000;
    static constexpr int ROWS = 8192; /* refreshes in each T_REF */
    static constexpr double T_REFI = T_REF / ROWS;
};

#endif
