// rt_shade_pass.vh - generated from machine.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// rt_shade_parameters.vh to an instance, by name.
        .COARSE(COARSE), .TEXTURE_LINES(TEXTURE_LINES), .TEXTURE_WAYS(TEXTURE_WAYS),
        .TEXTURE_GROUP(TEXTURE_GROUP), .TEXTURE_COORDS(TEXTURE_COORDS),
        .QUOTIENTS(QUOTIENTS), .QUOTIENT_STEP(QUOTIENT_STEP), .HIT_INTERVAL(HIT_INTERVAL),
        .BOUNCE_INTERVAL(BOUNCE_INTERVAL), .LINE_BITS(LINE_BITS),
