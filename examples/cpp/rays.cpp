// rays.cpp - every pixel's primary ray again, in one batch; what it hits is what the frame has
// SPDX-License-Identifier: Apache-2.0
//
// c++ rays.cpp -o rays $(pkg-config --cflags --libs sphaera)
// ./rays SCENE.nff [ACCEL]     prints how fast the batch is beside the frame of the same rays
#include <chrono>
#include <cstdio>

#include <sphaera/sphaera.hpp>

static double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

int main(int argc, char **argv) try {
    if (argc < 2) throw sphaera::Error("one scene, please");
    sphaera::BuildOptions options;
    options.profile = "standard";
    options.accel = argc > 2 ? argv[2] : "auto";
    options.width = 640, options.height = 360;
    options.depth = options.lights = 0; /* primary rays alone */
    options.texture = options.inside = SPHAERA_OFF;
    const sphaera::Machine machine = sphaera::Scene::read(argv[1]).build(options);

    std::vector<int32_t> origins, directions;
    for (int y = 0; y < machine.height(); y++)
        for (int x = 0; x < machine.width(); x++) {
            int32_t origin[3], direction[3];
            machine.primary(x, y, origin, direction);
            origins.insert(origins.end(), origin, origin + 3);
            directions.insert(directions.end(), direction, direction + 3);
        }
    sphaera::RenderOptions one;
    one.threads = 1;
    const sphaera::Hits once = machine.trace(origins, directions); /* the tree is decoded once */
    double best = 0;
    for (int i = 0; i < 5; i++) {
        double start = now();
        const sphaera::Frame frame = machine.render(one);
        double middle = now();
        const sphaera::Hits hits = machine.trace(origins, directions, 1);
        double ratio = (middle - start) / (now() - middle);
        best = ratio > best ? ratio : best;
        if (hits.id != frame.id() || hits.key != frame.key() || hits.visits != frame.visits() ||
            hits.id != once.id)
            throw sphaera::Error("a ray of the batch is not that of the frame");
    }
    std::printf("%zu rays as in the frame, %.2f of its rate\n", once.id.size(), best);
    return 0;
} catch (const std::exception &e) {
    std::fprintf(stderr, "rays: %s\n", e.what());
    return 1;
}
