/* silence.h - a block of code whose output on stdout is thrown away
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef TB_SILENCE_H
#define TB_SILENCE_H

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

/* While it lives nothing reaches stdout: before reset registers hold noise, and what assertions say
 * of it counts for nothing. */
class Silence {
  public:
    Silence() : out_(dup(1)) {
        std::fflush(stdout);
        int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, 1);
        close(nowhere);
    }
    ~Silence() {
        std::fflush(stdout);
        dup2(out_, 1);
        close(out_);
    }
    Silence(const Silence &) = delete;
    Silence &operator=(const Silence &) = delete;

  private:
    int out_;
};

#endif
