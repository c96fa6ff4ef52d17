/* guard.h - what ends a command from outside: signals, full disks, the memory that it may have
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_TOOL_GUARD_H
#define SPH_TOOL_GUARD_H

/* Called once, before any thread. From then on SIGINT, SIGTERM and SIGHUP, unless they are ignored,
 * remove temporary files, say so and end the program as they would; a closed pipe and a limit on
 * the size of files are errors of writing. Memory is limited to SPHAERA_MEMORY, a number of bytes
 * with K, M or G behind it, `unlimited`, or GUARD_MEMORY if the environment has none; stacks of
 * threads come on top. 0, or -1 with a message on stderr if SPHAERA_MEMORY is none of these. */
int guard_start(void);

/* Says on stderr how much memory there is, after a message that there is none. */
void guard_say_memory(void);

#define GUARD_MEMORY (1ull << 30) /* bytes */

#endif
