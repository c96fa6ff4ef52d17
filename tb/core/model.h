/* model.h - the golden model's C headers as C++ sees them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_MODEL_H
#define TB_MODEL_H

extern "C" {
#include "common/error.h"
#include "common/number.h"
#include "core/frame.h"
#include "core/stages.h"

#include "machine/camera.h"
#include "machine/machine.h"
#include "machine/parts.h"
#include "render/render.h"
#include "validate/describe.h"
#include "validate/validate.h"
}

#endif
