// rt_effects.vh - generated from machine.def by make layout; do not edit
// SPDX-License-Identifier: Apache-2.0
// Widths and effects: the first of the parameters of a module.
    parameter W          = `RT_PROFILE_STANDARD_W, // coordinate, bits
    parameter WD         = `RT_PROFILE_STANDARD_WD, // direction component, bits
    parameter PQ         = `RT_PROFILE_STANDARD_PQ, // significant bits of the quotient
    parameter NG         = `RT_PROFILE_STANDARD_NG, // guard bits of the normal
    parameter FW         = `RT_PROFILE_STANDARD_FW, // filter coordinate, bits
    parameter PR         = `RT_PROFILE_STANDARD_PR, // significant bits of the root, 0: all
    // effects that are elaborated, a machine that asks for more is refused (MISSING_EFFECT)
    parameter SHADOW     = 1,    // 0 or 1: rays towards the lights
    parameter REFLECT    = 5,    // 0..10: mirror rays, up to MAX_DEPTH
    parameter LIGHTS     = 8,    // 0..8: point lights
    parameter INSIDE     = 1,    // 0 or 1: rays may start inside a sphere, far roots count
    parameter FIRST      = 1,    // 0 or 1: primary rays end at the first visit that hits a leaf
    parameter INTERPENETRATE = 1, // 0 or 1: mends first hits that lie in another sphere
    parameter FACETS     = 1,    // 0 or 1: triangles and planes
    parameter TEXTURE    = 0,    // 0 or 1: images on surfaces
    parameter REFRACT    = 0,    // 0 or 1: refracted rays, mirror rays where all is reflected
    parameter SPECULAR   = 0,    // 0 or 1: highlights of materials with sum
    parameter SUM        = 0,    // 0 or 1: materials whose shares add up, colour on top of rays
    parameter SMOOTH     = 0,    // 0 or 1: interpolated normals of triangles
    parameter CLEAR      = 0,    // 0 or 1: shadow rays pass what is marked as clear
    parameter TURNED     = 0,    // 0 or 1: a grid in other axes than the camera's
    parameter SPREAD     = 0,    // 0 or 1: levels in mirrors and glass by how spheres spread rays
    parameter CAMERA     = 1,    // 0 or 1: any other camera is refused, since something is left out
