/* meet.c - see meet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/meet.h"

#include <math.h>

#include "machine/layout.h"
#include "reference/facet.h"

struct sph_ref_cast sph_ref_cast(const struct sph_ref_ray *ray) {
    struct sph_ref_cast c = {
        .ray = ray, .org = sph_ref_size(ray->org), .dir = sph_ref_size(ray->dir)};
    c.edge[0] = 12 * c.dir * (ray->off + SPH_REF_ULP * c.org);
    c.edge[1] = 6 * c.dir * (ray->turn + 3 * SPH_REF_ULP);
    return c;
}

/* Stable quadratic: the discriminant from the distance of centre and ray, the small root from the
 * product of the roots.
 *
 * e is how far the sphere's surface and the ray may be off against each other: what is lost in oc
 * and in the foot of the perpendicular on the ray is ULP times oc, centre and radius are granted as
 * much. The half chord, squared, is rad^2 - off2; |off| is off by e, so at the rim, where it is
 * rad, its square is off by e (2 rad + e). */
static int sphere(const struct sph_sphere *s, int own, const struct sph_ref_cast *cast,
                  struct sph_ref_meet *m) {
    const struct sph_ref_ray *ray = cast->ray;
    const double ctr[3] = {s->ctr.x, s->ctr.y, s->ctr.z}, *d = ray->dir;
    double oc[3], a = 0, b = 0, oc2 = 0, off2 = 0;
    for (int i = 0; i < 3; i++) {
        oc[i] = ctr[i] - ray->org[i];
        a += d[i] * d[i];
        b += oc[i] * d[i];
        oc2 += oc[i] * oc[i];
    }
    for (int i = 0; i < 3; i++) {
        double v = oc[i] - b / a * d[i];
        off2 += v * v;
    }
    double far = 2 * sph_ref_size(oc), half2 = s->rad * s->rad - off2;
    double e = SPH_REF_ULP * 2 * (far + sph_ref_size(ctr) + s->rad);
    double aside = e + ray->off + far * ray->turn, rim = aside * (2 * s->rad + aside);
    if (half2 < -rim) return 0;
    double disc = a * half2, c = oc2 - s->rad * s->rad, start = (e + ray->lift) * (far + s->rad);
    m->far = own || c <= start;
    if (!(b > 0) && !m->far) return 0;
    m->met = disc > 0;
    m->doubt = half2 < rim;
    if (!m->met) disc = 0;
    double root = sqrt(disc), q = b + copysign(root, b), length = sqrt(a);
    m->t = b >= 0 && m->far ? q / a : c / q;                  /* far, b < 0: -|c| / -|q| */
    double half = root / length, blur = e * (2 * s->rad + e); /* of half^2 */
    m->slack = (2 * e + (half * half > blur ? blur / half : sqrt(2 * blur))) / length;
    m->slack += SPH_REF_ULP * fabs(m->t);
    m->lead = 0;
    if (ray->lift > 0 && !own)
        m->lead = ray->lift * s->rad / sph_ref_most(half, ray->lift) / length;
    return m->met || m->doubt;
}

static int of_group(const struct sph_scene *s, uint32_t id, const struct sph_facet *f) {
    return id >= s->n_spheres && id != SPH_ID_NONE &&
           s->facets[id - s->n_spheres].group == f->group;
}

static int passes(const struct sph_scene *s, uint32_t id) {
    uint32_t material =
        id < s->n_spheres ? s->spheres[id].material : s->facets[id - s->n_spheres].material;
    return s->materials[material].passes;
}

int sph_ref_meet_ahead(const struct sph_scene *s, uint32_t id, const struct sph_ref_cast *cast,
                       struct sph_ref_meet *m) {
    const struct sph_ref_ray *ray = cast->ray;
    if (ray->light && passes(s, id)) return 0;
    int own = id == ray->skip;
    if (id < s->n_spheres) {
        if (own && !ray->inside) return 0;
        if (!sphere(&s->spheres[id], own, cast, m)) return 0;
    } else {
        const struct sph_facet *f = &s->facets[id - s->n_spheres];
        if (of_group(s, ray->skip, f) || !sph_ref_facet(f, cast, m)) return 0;
    }
    double around = m->slack + m->lead;
    if (own ? m->t > 0 : m->t > around) return 1;
    if (own || !(m->t >= -around) || ray->skip == SPH_ID_NONE || sph_ref_coincide(s, ray->skip, id))
        return 0;
    *m = (struct sph_ref_meet){.t = 0, .doubt = 1};
    return 1;
}

static int same_sphere(const struct sph_sphere *a, const struct sph_sphere *b) {
    const double at[3] = {a->ctr.x, a->ctr.y, a->ctr.z};
    const double off[3] = {b->ctr.x - at[0], b->ctr.y - at[1], b->ctr.z - at[2]};
    return sph_ref_size(off) + fabs(a->rad - b->rad) <=
           4 * SPH_REF_ULP * (sph_ref_size(at) + a->rad);
}

int sph_ref_coincide(const struct sph_scene *s, uint32_t a, uint32_t b) {
    if (a < s->n_spheres && b < s->n_spheres) return same_sphere(&s->spheres[a], &s->spheres[b]);
    if (a < s->n_spheres || b < s->n_spheres) return 0;
    return sph_ref_facet_level(&s->facets[a - s->n_spheres], &s->facets[b - s->n_spheres]);
}
