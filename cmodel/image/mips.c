/* mips.c - the images of a scene, read before it is built
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <string.h>

#include "image/texture.h"
#include "image/mips.h"

int sph_mips_load(const struct sph_scene *scene, struct sph_mip **mips, struct sph_error *err) {
    uint32_t n = scene->n_textures;
    *mips = NULL;
    if (!n) return 0;
    *mips = calloc(n, sizeof **mips);
    if (!*mips) return sph_fail(err, "%s: out of memory for %u images", scene->path, n);
    for (uint32_t i = 0; i < n; i++) {
        const struct sph_texture *t = &scene->textures[i];
        uint32_t same = 0;
        while (same < i && (scene->textures[same].colours != t->colours ||
                            strcmp(scene->textures[same].path, t->path) != 0))
            same++;
        (*mips)[i] = (*mips)[same];
        struct sph_error why = {{0}};
        if (same == i && sph_mip_load(t->path, t->colours, &(*mips)[i], &why)) {
            sph_mips_free(*mips, i);
            *mips = NULL;
            return t->line ? sph_fail(err, "%s:%u: texture: %.400s", scene->path, t->line, why.text)
                           : sph_fail(err, "%s: texture: %.400s", scene->path, why.text);
        }
    }
    return 0;
}

void sph_mips_free(struct sph_mip *mips, uint32_t n) {
    for (uint32_t i = 0; mips && i < n; i++) {
        uint32_t same = 0;
        while (same < i && mips[same].texels != mips[i].texels)
            same++;
        if (same == i) continue;
        mips[i].texels = NULL; /* freed with the first */
    }
    for (uint32_t i = 0; mips && i < n; i++)
        sph_mip_free(&mips[i]);
    free(mips);
}
