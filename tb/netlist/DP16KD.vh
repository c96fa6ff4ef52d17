// DP16KD.vh - the body of Lattice's block RAM, behind the head that Yosys has of it
// SPDX-License-Identifier: Apache-2.0
// 1024 words of 18 bits; a port of width 1, 2, 4, 9 or 18 sees a part of a word, one of width 36
// two of them (A writes, with B's data as the high word; B reads, with A's outputs as the low
// one). As Yosys uses it: without output registers, chip selects 0. Bits that one port writes while
// the other one reads them are read as noise: hardware promises nothing.
    `RT_CHECK(REGMODE_A == "NOREG" && REGMODE_B == "NOREG" && CLKAMUX == "CLKA" &&
              CLKBMUX == "CLKB", DP16KD_is_modelled_as_Yosys_uses_it)
    localparam [20479:0] INIT = {
        INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39,
        INITVAL_38, INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32,
        INITVAL_31, INITVAL_30, INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B,
        INITVAL_2A, INITVAL_29, INITVAL_28, INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24,
        INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20, INITVAL_1F, INITVAL_1E, INITVAL_1D,
        INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18, INITVAL_17, INITVAL_16,
        INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10, INITVAL_0F,
        INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
        INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01,
        INITVAL_00};
    reg  [17:0] mem [0:1023];
    integer     n;
    initial for (n = 0; n < 1024; n = n + 1) mem[n] = INIT[20*n +: 18];
    wire [13:0] ada = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2,
                       ADA1, ADA0};
    wire [13:0] adb = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2,
                       ADB1, ADB0};
    wire [17:0] dia = {DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7,
                       DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0};
    wire [17:0] dib = {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7,
                       DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0};
    reg  [17:0] doa, dob;
    assign {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5,
            DOA4, DOA3, DOA2, DOA1, DOA0} = RESETMODE == "ASYNC" && RSTA ? 18'd0 : doa;
    assign {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5,
            DOB4, DOB3, DOB2, DOB1, DOB0} = RESETMODE == "ASYNC" && RSTB ? 18'd0 : dob;

    // The bits of a word that a port of this width sees at this address, as a mask and a shift.
    function [4:0] place(input integer width, input [13:0] at);
        case (width)
            1:       place = 9 * at[3] + at[2:0];
            2:       place = 9 * at[3] + 2 * at[2:1];
            4:       place = 9 * at[3] + 4 * at[2];
            9:       place = 9 * at[3];
            default: place = 5'd0;
        endcase
    endfunction
    function [17:0] mask(input integer width, input [13:0] at); // of 18 bits: byte enables
        case (width)
            1, 2, 4, 9: mask = ((18'd1 << width) - 18'd1) << place(width, at);
            default:    mask = {{9{at[1]}}, {9{at[0]}}};
        endcase
    endfunction
    localparam A_WIDE = DATA_WIDTH_A == 36, B_WIDE = DATA_WIDTH_B == 36;
    wire [9:0]  a_at = A_WIDE ? {ada[13:5], 1'b0} : ada[13:4];
    wire [9:0]  b_at = B_WIDE ? {adb[13:5], 1'b0} : adb[13:4];
    wire [17:0] a_mask = mask(DATA_WIDTH_A, ada);
    wire [17:0] b_mask = mask(DATA_WIDTH_B, adb);
    wire [17:0] a_new = (mem[a_at] & ~a_mask) | ((dia << place(DATA_WIDTH_A, ada)) & a_mask);
    wire [17:0] b_new = (mem[b_at] & ~b_mask) | ((dib << place(DATA_WIDTH_B, adb)) & b_mask);
    wire        selected = !(CSA0 || CSA1 || CSA2 || CSB0 || CSB1 || CSB2);
    wire [17:0] a_high = A_WIDE ? {{9{ada[3]}}, {9{ada[2]}}} : 18'd0; // of the high word
    wire        a_writes = CEA && WEA && !RSTA && selected;
    wire        b_writes = CEB && WEB && !RSTB && selected;
    wire [9:0]  a_next = a_at | 10'd1, b_next = b_at | 10'd1;
    wire [17:0] a_old  = mem[a_at] ^ (b_writes && a_at == b_at ? b_mask : 18'd0);
    wire [17:0] b_old  = mem[b_at] ^ (!a_writes ? 18'd0 : b_at == a_at ? a_mask
                                      : b_at == a_next ? a_high : 18'd0);
    wire [17:0] b_high = mem[b_next] ^ (!a_writes ? 18'd0 : b_next == a_at ? a_mask
                                        : b_next == a_next ? a_high : 18'd0);

    generate
        if (B_WIDE) begin : g_wide_read
            always @(posedge CLKB)
                if (RSTB) {dob, doa} <= 36'd0;
                else if (CEB) {dob, doa} <= {b_high, b_old};
        end else begin : g_reads
            always @(posedge CLKA)
                if (RSTA) doa <= 18'd0;
                else if (CEA && !(WEA && WRITEMODE_A == "NORMAL"))
                    doa <= (WEA && WRITEMODE_A == "WRITETHROUGH" ? a_new : a_old)
                           >> place(DATA_WIDTH_A, ada);
            always @(posedge CLKB)
                if (RSTB) dob <= 18'd0;
                else if (CEB && !(WEB && WRITEMODE_B == "NORMAL"))
                    dob <= (WEB && WRITEMODE_B == "WRITETHROUGH" ? b_new : b_old)
                           >> place(DATA_WIDTH_B, adb);
        end
    endgenerate
    always @(posedge CLKA)
        if (a_writes) begin
            mem[a_at] <= a_new;
            if (A_WIDE) mem[a_next] <= (mem[a_next] & ~a_high) | (dib & a_high);
        end
    generate
        if (!A_WIDE && !B_WIDE) begin : g_writes
            always @(posedge CLKB) if (b_writes) mem[b_at] <= b_new;
        end
    endgenerate
endmodule
