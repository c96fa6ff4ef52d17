// query.cpp - rays through a scene, from many threads at once
// SPDX-License-Identifier: Apache-2.0
//
// c++ query.cpp -o query $(pkg-config --cflags --libs sphaera) -pthread
// ./query SCENE.nff        a row of rays along -z, what they hit and how far away
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sphaera/sphaera.h>

using Scene = std::unique_ptr<sphaera_scene, decltype(&sphaera_scene_free)>;
using Machine = std::unique_ptr<sphaera_machine, decltype(&sphaera_machine_free)>;

static Machine machine_of(const char *path) {
    sphaera_error error = {};
    sphaera_scene *scene = nullptr;
    sphaera_machine *machine = nullptr;
    if (sphaera_scene_read(path, 0, &scene, &error)) throw std::runtime_error(error.text);
    Scene keep(scene, sphaera_scene_free);
    if (sphaera_build(scene, nullptr, &machine, &error)) throw std::runtime_error(error.text);
    return Machine(machine, sphaera_machine_free);
}

int main(int argc, char **argv) try {
    if (argc != 2) throw std::runtime_error("one scene, please");
    const Machine machine = machine_of(argv[1]);
    const int rays = 9;
    std::vector<sphaera_hit> hits(rays);
    std::vector<std::string> wrong(rays);
    std::vector<std::thread> threads;
    for (int i = 0; i < rays; i++)
        threads.emplace_back([&, i] {
            const double origin[3] = {0.4 * (i - rays / 2), 0, 4}, direction[3] = {0, 0, -1};
            sphaera_error error = {};
            if (sphaera_trace(machine.get(), origin, direction, &hits[i], &error))
                wrong[i] = error.text;
        });
    for (auto &thread : threads)
        thread.join();
    for (int i = 0; i < rays; i++)
        if (!wrong[i].empty())
            std::printf("%d %s\n", i, wrong[i].c_str());
        else if (hits[i].id == SPHAERA_NONE)
            std::printf("%d nothing\n", i);
        else
            std::printf("%d id %u distance %.3f z %.3f\n", i, hits[i].id, hits[i].distance,
                        hits[i].point[2]);
    return 0;
} catch (const std::exception &e) {
    std::fprintf(stderr, "query: %s\n", e.what());
    return 1;
}
