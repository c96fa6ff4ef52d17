/* tb_uart.cpp - rt_uart with itself: bytes arrive, each bit lasts DIV clocks
 * SPDX-License-Identifier: Apache-2.0
 *
 * What is sent comes back as what is received; the line is looked at in every clock. A stop bit
 * that is low takes its byte away.
 */
#include "Vrt_uart.h"
#include "bench.h"

int main(int argc, char **argv) {
    bench::Bench<Vrt_uart> b("tb_uart", argc, argv, 8);
    if (b.target > 8) b.target = 8; /* of 200 000 clocks each */
    Vrt_uart &dut = b.dut;
    dut.rx_i = 1;
    dut.put_valid_i = 0;
    b.reset();
    while (b.more()) {
        const unsigned byte = (unsigned)b.random.below(256), bits = (byte | 256) << 1;
        const bool cut = b.random.percent(30);
        unsigned got = 0, value = 0;
        b.expect("put_ready_o", dut.put_ready_o, 1);
        dut.put_data_i = (uint8_t)byte;
        dut.put_valid_i = 1;
        b.tick();
        dut.put_valid_i = 0;
        for (unsigned clock = 0; clock < 11u * DIV; clock++) {
            const unsigned bit = clock / DIV;
            if (bit < 10) b.expect("put_ready_o while a byte is sent", dut.put_ready_o, 0);
            b.expect("tx_o", dut.tx_o, bit < 10 ? bits >> bit & 1 : 1);
            dut.rx_i = cut && bit == 9 ? 0 : dut.tx_o;
            b.tick();
            if (dut.get_valid_o) got++, value = dut.get_data_o;
            b.cycle = 0;
        }
        b.expect("bytes", got, cut ? 0 : 1);
        if (got) b.expect("get_data_o", value, byte);
        for (unsigned n = cut ? 11u * DIV : 0; n--;) /* the low stop bit began another byte */
            b.tick();
        b.cycle = 0;
        b.done();
    }
    return b.finish();
}
