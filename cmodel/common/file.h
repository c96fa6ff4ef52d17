/* file.h - files that are read: regular ones; files that are written: whole or not at all
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_COMMON_FILE_H
#define SPH_COMMON_FILE_H

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"

/* ---- files that are read: regular ones, of a size that their reader can bear ---- */

#define SPH_INPUT_ANY (1ll << 62) /* bytes: the reader keeps no more than it can use */

/* Opens the regular file at path, of at most `most` bytes, for reading. NULL with "path: message":
 * missing, no permission, a folder, a device, a pipe, a socket, too large. Never waits. */
FILE *sph_input_open(const char *path, long long most, struct sph_error *err);

/* Whether the file at path starts with these n bytes, at most 16; 0 if it cannot be opened. */
int sph_input_starts(const char *path, const char *bytes, size_t n);

/* ---- files that are written whole or not at all ---- */
/* A file is written under a temporary name, PATH.RANDOM.ENDING, in the folder of its final one, and
 * renamed when it is on the disk. The temporary file is new, with the rights that a new file gets:
 * no link that stands there is followed, and two threads, processes or containers never get the
 * same name. A device or a pipe, which has no final name to be renamed to, is written directly. */

struct sph_output {
    FILE *file;
    int renamed;                      /* 0: written directly */
    char path[4096], temporary[4096]; /* temporary: empty if there is none */
};

/* Opens path for writing ("-": standard output) as out->file. 0, or -1 with a message. */
int sph_output_open(struct sph_output *out, const char *path, struct sph_error *err);

/* The same for a file that something else writes by its name, out->temporary, which ends in
 * `ending`; out->file stays empty. A device or a pipe is refused. */
int sph_output_open_named(struct sph_output *out, const char *path, const char *ending,
                          struct sph_error *err);

/* Waits for the disk, closes and renames, and tells which of these, or a write, failed: what had
 * that name before is then still there. With failed != 0 closes and removes instead.
 * 0, or -1 (with a message unless failed). */
int sph_output_close(struct sph_output *out, int failed, struct sph_error *err);

/* ---- what is left when a signal ends the program ---- */

/* Notes a temporary file, or a folder of such files, and forgets it. A path that finds no memory is
 * not noted. */
void sph_output_note(const char *path);
void sph_output_forget(const char *path);

/* Removes all that is noted, of other objects too, and lets nobody note anything more: the program
 * ends. To be called by a thread of its own that waits for signals, not by a handler. */
__attribute__((visibility("default"))) void sph_output_clean(void);

/* An object that was loaded has this function of its own: it is called too. */
void sph_output_also(void (*clean)(void));

#ifdef __cplusplus
}
#endif

#endif
