/* model.h - the golden model's C headers as C++ sees them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_MODEL_H
#define TB_MODEL_H

extern "C" {
#include "error.h"
#include "frame.h"
#include "frame_file.h"
#include "machine/describe.h"
#include "machine/machine.h"
#include "render.h"
}

#endif
