// rt_effects_pass.vh - generated from machine.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// rt_effects.vh to an instance, by name: the first that it is given.
        .W(W), .WD(WD), .PQ(PQ), .NG(NG), .FW(FW), .PR(PR), .SHADOW(SHADOW),
        .REFLECT(REFLECT), .LIGHTS(LIGHTS), .INSIDE(INSIDE), .FIRST(FIRST),
        .INTERPENETRATE(INTERPENETRATE), .FACETS(FACETS), .TEXTURE(TEXTURE),
        .REFRACT(REFRACT), .SPECULAR(SPECULAR), .SUM(SUM), .SMOOTH(SMOOTH), .CLEAR(CLEAR),
        .TURNED(TURNED), .SPREAD(SPREAD), .CAMERA(CAMERA),
