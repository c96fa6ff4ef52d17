/* sphaera_modes.h - generated from modes.def by make layout; do not edit
 * SPDX-License-Identifier: Apache-2.0
 * SPHAERA_MODES(X): X(name, kHz, fields as SPHAERA_MODE_FIELDS names them) each. */
#ifndef SPHAERA_MODES_H
#define SPHAERA_MODES_H
#define SPHAERA_MODE_FIELDS h_active, h_front, h_sync, h_back, v_active, v_front, v_sync, v_back, h_pol, v_pol
#define SPHAERA_MODES(X) \
    X("640x480", 25175, 640, 16, 96, 48, 480, 10, 2, 33, 0, 0) \
    X("800x480", 29500, 800, 24, 72, 96, 480, 3, 7, 10, 0, 1) \
    X("1280x720", 74250, 1280, 110, 40, 220, 720, 5, 5, 20, 1, 1) \
    X("1920x1080", 148500, 1920, 88, 44, 148, 1080, 4, 5, 36, 1, 1)
#endif
