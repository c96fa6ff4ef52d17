/* stage_watch.h - follows one pixel through a verilated core and notes its stages
 * SPDX-License-Identifier: Apache-2.0
 *
 * Reads the signals that stages.vlt makes visible and notes them as the model notes its own
 * (core/stages.h). All rays of a pixel run one after another in one slot, so which ray and which
 * visit a word belongs to follows from the order of events in that slot. No stage of the RTL waits
 * for it, and none is changed by it.
 */
#ifndef TB_STAGE_WATCH_H
#define TB_STAGE_WATCH_H

#include <memory>

#include "model.h"

class VerilatedContext;

class StageWatch {
  public:
    /* After the first clock of the core that was made in this context; pixel x, y of the machine,
     * into `to`. */
    StageWatch(VerilatedContext &context, const sph_machine &machine, int x, int y, sph_stages &to);
    ~StageWatch();
    /* Before every clock edge, when all has settled. */
    void clock();
    /* Bit SPH_STAGE_*: the core has this stage, and shows it; 0: it was built without stages.vlt.
     */
    uint32_t shown() const;

  private:
    class Core;
    std::unique_ptr<Core> core_;
};

#endif
