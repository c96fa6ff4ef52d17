/* tb_cone.cpp - rt_cone against the discriminant and projection of its sphere, evaluated directly
 * SPDX-License-Identifier: Apache-2.0
 *
 * Random moves; the bench keeps the three places as pixels. Half of the records are spheres seen
 * from the eye (k*a + b^2 and oc.dir in wide integers), half any bits (the contract's formula).
 */
#include "Vrt_cone.h"
#include "bench.h"
#include "cone.h"

namespace {

constexpr int FB = 2 * W + 2 * WD + 4, BB = W + WD + 4;

struct Place {
    int x, y;
};

/* The unit, its record, and the three places that it holds. */
class Run {
  public:
    Run(int argc, char **argv) : b("tb_cone", argc, argv) {
        b.dut.load_i = 0;
        move(false, false, false, false);
    }
    bool clock() { /* false at the end */
        if (!b.more()) return false;
        if (left-- == 0) {
            load();
            left = (int)b.random.below(200);
        }
        step();
        compare();
        return true;
    }
    int finish() { return b.finish(); }

  private:
    bench::Bench<Vrt_cone> b;
    bench::Ball s{};
    bench::Cone c{};
    bool real = false;
    int side = 0, left = 0; /* of the frame; moves with this record */
    Place saved{}, row{}, pixel{};

    void move(bool fetch, bool enter, bool right, bool save) {
        b.dut.fetch_i = fetch;
        b.dut.enter_i = enter;
        b.dut.right_i = right;
        b.dut.save_i = save;
        b.tick();
        b.dut.fetch_i = b.dut.enter_i = b.dut.right_i = b.dut.save_i = 0;
        Place before = pixel;
        if (enter) pixel = row, row.y++;
        if (right) pixel.x++;
        if (fetch) row = saved;
        if (save) saved = before;
    }
    /* Another record, real or any, and a place in its frame. */
    void load() {
        uint32_t words[32];
        side = (int)b.random.between(2, b.random.percent(5) ? 400 : 60);
        real = b.random.percent(50);
        if (real) s = bench::ball(b.random, W, WD, side);
        c = real ? bench::Cone::of(s) : bench::Cone::any(b.random, FB, BB);
        c.store(words);
        for (int line : {0, 1, 2, 3}) {
            for (int i = 0; i < 8; i++)
                b.dut.line_i[i] = words[8 * line + i];
            b.dut.load_i = 1 << line;
            b.tick();
            b.dut.load_i = 0;
            for (int i = 0; i < 8; i++) /* without load it does not matter */
                b.dut.line_i[i] = (uint32_t)b.random.next();
            if (b.random.percent(20)) b.tick();
        }
        saved = {0, 0};
        move(true, false, false, false);
        move(false, true, false, false);
        for (int y = (int)b.random.below((uint64_t)side); y > 0; y--)
            move(false, true, false, false);
    }

    void step() {
        uint64_t how = b.random.below(100);
        if (how < 75 && pixel.x < side - 1)
            move(false, false, true, false);
        else if (how < 90 && row.y < side)
            move(false, true, false, how < 85);
        else if (how < 95)
            move(false, false, false, true);
        else
            move(true, false, false, false);
    }

    void compare() {
        if (real && (c.f_at(pixel.x, pixel.y, 128) != s.f(pixel.x, pixel.y)))
            b.fail("the bench's record is not its sphere");
        bool hit = real ? s.f(pixel.x, pixel.y) > 0 && (s.b(pixel.x, pixel.y) > 0 || s.k > 0)
                        : c.hit(pixel.x, pixel.y, FB, BB);
        b.expect("hit_o", b.dut.hit_o, hit, 1);
        if (b.bad()) {
            b.show("x", pixel.x, 16);
            b.show("y", pixel.y, 16);
            b.show("f", c.f_at(pixel.x, pixel.y, FB), FB);
            b.show("b", c.b_at(pixel.x, pixel.y, BB), BB);
            b.show("inside", c.inside, 1);
        }
        b.done();
    }
};

} // namespace

int main(int argc, char **argv) {
    Run run(argc, argv);
    while (run.clock())
        ;
    return run.finish();
}
