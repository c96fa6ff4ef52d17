// machine.cpp - from arrays to a machine, and everything that is known of it
// SPDX-License-Identifier: Apache-2.0
//
// c++ machine.cpp -o machine $(pkg-config --cflags --libs sphaera)
// ./machine
#include <cstdio>

#include <sphaera/sphaera.hpp>

static void expect(bool same, const char *what) {
    std::printf("%s: %s\n", what, same ? "yes" : "NO");
}

int main() try {
    double spheres[] = {-1, 0, 0, 1.2, 1.4, 0.4, -1, 1, 1.4, 0.4, -1, 1}; /* one twice */
    const double lights[] = {4, 6, 8};
    sphaera::Arrays arrays;
    arrays.from[2] = 9, arrays.angle = 40, arrays.width = 48, arrays.height = 32;
    arrays.spheres = spheres, arrays.n_spheres = 3;
    arrays.lights = lights, arrays.n_lights = 1;
    const sphaera::Scene scene = sphaera::Scene::make(arrays);
    for (const sphaera_record &r : scene.records())
        if (r.end != std::string("used"))
            std::printf("%s, row %u: %s: %s\n", r.file, r.line, r.end, r.kind);
    scene.write("machine.nff");

    int told = 0;
    sphaera::BuildOptions build;
    build.background = "spans";
    build.user = &told;
    build.progress = [](void *user, int, int) -> int { return ++*static_cast<int *>(user) < 0; };
    const sphaera::Machine machine = scene.build(build);
    expect(told > 1, "build tells how far it is");
    const sphaera::Frame frame = machine.render();
    const sphaera::Machine same = sphaera::Machine::make(machine.registers(), machine.memory());
    expect(same.render().hash() == frame.hash(), "registers and memory are all of a machine");
    build.user = nullptr, build.progress = nullptr;
    expect(sphaera::Scene::read("machine.nff").build(build).render().hash() == frame.hash(),
           "the file is the scene");
    std::printf("core %s, %zu parameters, %zu lines\n", machine.core().c_str(),
                machine.parameters().size(), machine.memory().size() / 8);

    build.refit = 1; /* the tree of the first scene around what moves */
    const sphaera::Machine first = scene.build(build);
    spheres[0] = -1.4;
    const sphaera::Scene later = sphaera::Scene::make(arrays);
    const sphaera::Machine refitted = later.refit(first);
    expect(refitted.render().id() == later.build(build).render().id(), "a refitted tree shows it");

    const sphaera::Pixel pixel = machine.pixel(17, 16);
    const sphaera::Layers layers = frame.layers();
    size_t at = 16 * 48 + 17;
    expect(pixel.rays[0].id == frame.id()[at] && pixel.rays[0].key == frame.key()[at],
           "the pixel's ray hits what the frame has");
    std::printf("%zu rays, %zu stages, the last: %s\n", pixel.rays.size(), pixel.stages.size(),
                pixel.stages.back().stage.name);
    std::printf("distance %.1f, normal z %.1f\n", layers.distance[at], layers.normal[3 * at + 2]);
    for (const auto &counter : frame.counters())
        if (counter.first == "rays_primary")
            std::printf("%s %llu\n", counter.first.c_str(),
                        static_cast<unsigned long long>(counter.second));
    build.background = "none";
    for (const sphaera::PriceRow &row : scene.price(build).rows)
        std::printf("%s %s\n", row.name.c_str(), row.row.keeps ? "keeps" : "misses");
    try {
        machine.trace(std::vector<double>{0, 0, 0}, std::vector<double>{0, 0, 0});
    } catch (const sphaera::Error &e) {
        std::printf("error: %s\n", e.what());
    }
    return 0;
} catch (const std::exception &e) {
    std::fprintf(stderr, "machine: %s\n", e.what());
    return 1;
}
