/* visit.c - see visit.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trace/visit.h"

#include "core/stages.h"
#include "machine/records.h"
#include "trace/box.h"
#include "trace/node.h"

/* Near children come first, equal ones in the order of the node. */
static void insert(struct sph_siblings *s, uint32_t child, int32_t near) {
    int at = s->count++;
    for (; at > 0 && near < s->list[at - 1].near; at--)
        s->list[at] = s->list[at - 1];
    s->list[at].child = (uint8_t)child;
    s->list[at].near = near;
}

/* Whether the ray meets child i of a node, and where; axes: of the frame of boxes, or NULL. */
static int meets(const struct sph_ray *ray, const struct sph_box_axis *axes, const uint32_t *line,
                 int i, int32_t depth_max, int32_t *near) {
    if (axes) {
        struct sph_box_planes planes = sph_box_planes_read(line, i);
        return sph_box_meets(axes, ray, &planes, depth_max, near);
    }
    struct sph_child child = sph_child_read(line, i);
    return sph_filter(ray, &child, depth_max, near);
}

int sph_visit(const struct sph_machine *m, const struct sph_ray *ray, const struct sph_bih_ray *bih,
              uint32_t node, int32_t depth_max, struct sph_found *found) {
    const uint32_t *line = sph_line(m, node);
    uint32_t base = sph_field(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n_inner = sph_field(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t n_leaf = sph_field(line, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    found->inner.base = base;
    found->inner.count = 0;
    found->leaves = 0;
    found->line = base + n_inner;
    found->tests = n_inner + n_leaf;
    SPH_NOTE(ray->stages, SPH_STAGE_NODE, 0, node, base, n_inner, n_leaf);
    if (found->tests > 4 ||
        found->line + sph_record_lines(sph_whole(m), n_leaf) > (uint32_t)m->regs[SPH_REG_MEM_LINES])
        return 0;
    struct sph_box_axis axes[3];
    if (bih) {
        struct sph_box_frame frame = sph_box_frame_read(line, sph_machine_profile(m));
        sph_box_axes(sph_machine_profile(m), bih, ray, &frame, axes);
    }
    for (uint32_t i = 0; i < found->tests; i++) {
        int32_t near;
        if (!meets(ray, bih ? axes : NULL, line, (int)i, depth_max, &near)) continue;
        if (i < n_inner)
            insert(&found->inner, i, sph_ray_any(ray) ? INT16_MIN : near);
        else
            found->leaves |= 1u << (i - n_inner);
    }
    return 1;
}
