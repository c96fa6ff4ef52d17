/* shaded_scene.h - the scene of shaded_pixels.h, with colours and effects that change
 * SPDX-License-Identifier: Apache-2.0
 *
 * Who includes this has named the module `Top`.
 */
#ifndef TB_SHADED_SCENE_H
#define TB_SHADED_SCENE_H

#include <set>

#include "engine/parts.h"
#include "engine/world.h"

extern "C" {
#include "texture/lookup.h"
}

#ifndef SHADOW
#define SHADOW 1
#endif
#ifndef DEEP
#define DEEP 3
#endif
#ifndef LIGHTS
#define LIGHTS 8
#endif
#ifndef TEXTURE
#define TEXTURE 0
#endif
#ifndef FACETS
#define FACETS 0
#endif
#ifndef REFRACT
#define REFRACT 0
#endif
#ifndef SUM
#define SUM 0
#endif
#ifndef INTERPENETRATE
#define INTERPENETRATE 1
#endif

namespace {

/* Surfaces are probed: by one unit, and first hits are of spheres. */
constexpr bool PROBES = INTERPENETRATE && SHADES == 1 && !FACETS;

class ShadedScene : public bench::Bench<Top> {
  protected:
    ShadedScene(const char *name, int argc, char **argv, long pixels)
        : Bench(name, argc, argv, pixels), world(0, DEEP), effects(world.m.regs[SPH_REG_EFFECTS]),
          depth(world.m.regs[SPH_REG_MAX_DEPTH]), lights(world.m.regs[SPH_REG_N_LIGHTS]) {
        if (TEXTURE) scatter();
        bench::put(dut.light_i, RT_LIGHT_VALID, 0);
    }

    /* Nothing is under way: colours are others, effects are switched on and off. */
    void change() {
        paint();
        write_lights();
        static const int switched[] = {SPH_EFFECT_SHADOW,   SPH_EFFECT_REFLECT, SPH_EFFECT_REFRACT,
                                       SPH_EFFECT_SPECULAR, SPH_EFFECT_SUM,     SPH_EFFECT_TEXTURE};
        world.m.regs[SPH_REG_EFFECTS] = effects;
        for (int effect : switched)
            if (random.percent(effect == SPH_EFFECT_SHADOW ? 40 : 20))
                world.m.regs[SPH_REG_EFFECTS] &= ~(1 << effect);
        if (PROBES && random.percent(40))
            world.m.regs[SPH_REG_EFFECTS] |= 1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_INTERPENETRATE;
        world.m.regs[SPH_REG_N_LIGHTS] =
            random.percent(70) ? lights : (int32_t)random.below((uint64_t)lights + 1);
        if (++changes % 4 == 0) unlit();
        world.m.regs[SPH_REG_BG_COLOUR] = (int32_t)random.mixed(24);
        for (int i = 0; i < 3; i++)
            world.m.regs[SPH_REG_AMBIENT_R + i] = (int32_t)random.log_bits(16);
        world.m.regs[SPH_REG_MAX_DEPTH] = random.percent(60) ? depth : (int32_t)random.below(4);
        world.m.regs[SPH_REG_LEAST_WEIGHT] = random.percent(60) ? 0 : (int32_t)random.below(257);
        if (TEXTURE) world.m.regs[SPH_REG_TEX_FILTER] = (int32_t)random.below(SPH_FILTERS);
        world.put_regs(dut.regs_i);
    }

    world::World world;

  private:
    const int32_t effects, depth, lights; /* as the scene wants them */
    unsigned changes = 0;

    /* Images of textures lie anywhere in memory. */
    void scatter() {
        std::set<uint32_t> maps;
        world.repeat();
        for (int32_t i = 0; i < world.m.regs[SPH_REG_N_PRIMS]; i++) {
            uint32_t map = sph_field(prim(i), SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
            if (!map || !maps.insert(map).second) continue;
            uint32_t *record = sph_line(&world.m, map);
            uint32_t image = sph_field(record, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
            image += world::Repeated::ALIKE * (uint32_t)random.mixed(world::Repeated::PART_BITS);
            sph_field_set(record, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS, image);
        }
    }

    uint32_t *prim(int32_t id) {
        return sph_line(&world.m, (uint32_t)(world.m.regs[SPH_REG_PRIM_BASE] + id));
    }

    /* Each primitive gets a colour and shares of light, each light a colour, mostly a bright one;
     * highlights are mostly wide. */
    void paint() {
        for (int32_t i = 0; i < world.m.regs[SPH_REG_N_PRIMS]; i++) {
            auto put = [&](int lsb, int bits, bench::u128 x) {
                sph_field_set(prim(i), lsb, bits, (uint32_t)x);
            };
            put(SPH_PRIM_RED_LSB, 24, random.bits(24));
            put(SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS, random.log_bits(SPH_PRIM_KA_BITS));
            put(SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS, random.log_bits(SPH_PRIM_KD_BITS));
            put(SPH_PRIM_KS_LSB, SPH_PRIM_KS_BITS, random.bits(SPH_PRIM_KS_BITS));
            put(SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS,
                random.log_bits(random.percent(50) ? 3 : SPH_PRIM_POWER_BITS));
        }
        for (int l = 0; l < lights; l++)
            for (int c = SPH_REG_LIGHT0_R; c <= SPH_REG_LIGHT0_B; c++) {
                int32_t &reg = world.m.regs[c + l * SPH_LIGHT_STRIDE];
                uint32_t colour = (uint32_t)random.bits(random.percent(70) ? 16 : 15);
                reg = (int32_t)(((uint32_t)reg & ~0xffffu) | colour);
            }
    }

    void write_lights() {
        for (int l = 0; l < lights; l++)
            for (int part = 0; part < 6; part++) {
                bench::put(dut.light_i, RT_LIGHT_VALID, 1);
                bench::put(dut.light_i, RT_LIGHT_NUMBER, l);
                bench::put(dut.light_i, RT_LIGHT_PART, part);
                bench::put(dut.light_i, RT_LIGHT_DATA,
                           world.m.regs[SPH_REG_LIGHT0_X + l * SPH_LIGHT_STRIDE + part]);
                tick();
            }
        bench::put(dut.light_i, RT_LIGHT_VALID, 0);
    }

    /* Nothing asks for a surface's point, or a refracted ray alone does. */
    void unlit() {
        world.m.regs[SPH_REG_N_LIGHTS] = 0;
        int32_t &on = world.m.regs[SPH_REG_EFFECTS];
        for (int effect : {SPH_EFFECT_REFLECT, SPH_EFFECT_INTERPENETRATE, SPH_EFFECT_FIRST,
                           SPH_EFFECT_REFRACT, SPH_EFFECT_TEXTURE})
            on &= ~(1 << effect);
        if (changes % 8 == 0) on |= effects & 1 << SPH_EFFECT_REFRACT;
    }
};

} // namespace

#endif
