/* inside.h - files that a scene names: which of them are read
 * SPDX-License-Identifier: Apache-2.0
 *
 * A scene may come from a stranger. What it names is read if it lies in the folder of the scene
 * file or below, links followed; of AFF also in TextureFiles beside that folder; or anywhere if
 * whoever reads the scene says so: sph_read_options.allow_paths.
 */
#ifndef SPH_SCENE_INSIDE_H
#define SPH_SCENE_INSIDE_H

#include "scene/scene.h"

/* What messages say of a file that is not read. */
#define SPH_OUTSIDE "is outside the folder of the scene, see --allow-paths"

/* Whether the scene, whose path is set, may have the file at path read, or "file#part" of it; it
 * need not be there. */
int sph_scene_may_read(const struct sph_scene *scene, const char *path);

#endif
