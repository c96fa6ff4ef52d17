// sphaera.hpp - sphaera.h for C++11: objects that free themselves, vectors, exceptions
// SPDX-License-Identifier: Apache-2.0
//
// What a function does, its units and ranges stand in sphaera.h at the function of C that it calls.
// Whatever that refuses throws sphaera::Error with its message. Objects may be moved, not copied.
#ifndef SPHAERA_SPHAERA_HPP
#define SPHAERA_SPHAERA_HPP

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sphaera.h"

namespace sphaera {

class Error : public std::runtime_error {
  public:
    explicit Error(const char *text) : std::runtime_error(text) {}
};

// Options with the defaults of the library.
struct ReadOptions : sphaera_read_options {
    ReadOptions() { sphaera_read_init(this); }
};
struct BuildOptions : sphaera_build_options {
    BuildOptions() { sphaera_build_init(this); }
};
struct RenderOptions : sphaera_render_options {
    RenderOptions() { sphaera_render_init(this); }
};
struct PictureOptions : sphaera_picture_options {
    PictureOptions() { sphaera_picture_init(this); }
};
struct Arrays : sphaera_arrays {
    Arrays() { sphaera_arrays_init(this); }
};

// What n rays hit.
struct Hits {
    std::vector<uint32_t> id, visits;
    std::vector<uint64_t> key;
    std::vector<uint8_t> inside;
    std::vector<double> distance;
};

// Layers of a frame, row by row.
struct Layers {
    std::vector<uint32_t> texture;
    std::vector<float> level, normal, depth, distance, albedo;
};

// A stage of a ray, with its operands and its line of text.
struct Stage {
    sphaera_stage stage;
    std::vector<sphaera_operand> operands;
    std::string text;
};

// The rays of a pixel, in the order in which they are traced, and their stages.
struct Pixel {
    std::vector<sphaera_ray> rays;
    std::vector<Stage> stages;
};

// A row of what accuracy costs; why is empty, or says that nothing could be built.
struct PriceRow {
    std::string name, why;
    sphaera_price_row row; // its texts are those above
};

// best: number of the cheapest row that keeps what was asked for; -1: none does.
struct Price {
    std::vector<PriceRow> rows;
    int best;
};

namespace detail {
template <class T, void (*FREE)(T *)> struct Free {
    void operator()(T *p) const { FREE(p); }
};
template <class T, void (*FREE)(T *)> using Handle = std::unique_ptr<T, Free<T, FREE>>;

// Calls a function of C whose last argument is a sphaera_error *.
template <class F, class... A> void call(F function, A... arguments) {
    sphaera_error error = {};
    if (function(arguments..., &error)) throw Error(error.text);
}

// The same of one that fills a T ** before that.
template <class T, class F, class... A> T *make(F function, A... arguments) {
    T *made = nullptr;
    call(function, arguments..., &made);
    return made;
}

// Rows that a function of C gives by number until it returns -1.
template <class Row, class F, class T> std::vector<Row> rows(F function, T of) {
    std::vector<Row> all;
    Row row;
    while (!function(of, static_cast<int>(all.size()), &row))
        all.push_back(row);
    return all;
}
} // namespace detail

class Machine;

class Frame {
  public:
    int width() const { return sphaera_frame_width(p.get()); }
    int height() const { return sphaera_frame_height(p.get()); }
    uint64_t hash() const { return sphaera_frame_hash(p.get()); }
    uint32_t errors() const { return sphaera_frame_errors(p.get()); }
    std::vector<uint8_t> rgb(int layer = 2) const {
        std::vector<uint8_t> all(3 * pixels());
        if (sphaera_frame_rgb(p.get(), layer, all.data())) throw Error("layer is not 0 to 2");
        return all;
    }
    std::vector<uint32_t> id() const { return filled<uint32_t>(sphaera_frame_id); }
    std::vector<uint64_t> key() const { return filled<uint64_t>(sphaera_frame_key); }
    std::vector<uint32_t> visits() const { return filled<uint32_t>(sphaera_frame_visits); }
    Layers layers() const {
        Layers all;
        size_t n = pixels();
        all.texture.resize(n), all.level.resize(n), all.normal.resize(3 * n);
        all.depth.resize(n), all.distance.resize(n), all.albedo.resize(3 * n);
        const sphaera_layers to = {all.texture.data(), all.level.data(),    all.normal.data(),
                                   all.depth.data(),   all.distance.data(), all.albedo.data()};
        detail::call(sphaera_frame_layers, p.get(), &to);
        return all;
    }
    // By name: all counters, in their order.
    std::vector<std::pair<std::string, uint64_t>> counters() const {
        std::vector<std::pair<std::string, uint64_t>> all;
        for (int i = 0; sphaera_counter_name(i); i++)
            all.emplace_back(sphaera_counter_name(i), sphaera_frame_counter(p.get(), i));
        return all;
    }
    void write(const std::string &path, const PictureOptions &options = PictureOptions()) const {
        detail::call(sphaera_frame_write_with, p.get(), path.c_str(),
                     static_cast<const sphaera_picture_options *>(&options));
    }
    const sphaera_frame *get() const { return p.get(); }

  private:
    friend class Machine;
    explicit Frame(sphaera_frame *frame) : p(frame) {}
    size_t pixels() const { return static_cast<size_t>(width()) * static_cast<size_t>(height()); }
    template <class T> std::vector<T> filled(void (*fill)(const sphaera_frame *, T *)) const {
        std::vector<T> all(pixels());
        fill(p.get(), all.data());
        return all;
    }
    detail::Handle<sphaera_frame, sphaera_frame_free> p;
};

class Machine {
  public:
    static Machine read(const std::string &path) {
        return Machine(detail::make<sphaera_machine>(sphaera_machine_read, path.c_str()));
    }
    static Machine make(const std::vector<int32_t> &registers, const std::vector<uint32_t> &memory,
                        const std::string &name = "memory") {
        return Machine(detail::make<sphaera_machine>(
            sphaera_machine_make, registers.data(), static_cast<int>(registers.size()),
            memory.data(), static_cast<uint32_t>(memory.size() / 8), name.c_str()));
    }
    void write(const std::string &path) const {
        detail::call(sphaera_machine_write, p.get(), path.c_str());
    }
    // "hex" or "c", as `sphaera export`
    void write(const std::string &path, const std::string &format) const {
        detail::call(sphaera_machine_export, p.get(), format.c_str(), path.c_str());
    }
    int width() const { return sphaera_machine_width(p.get()); }
    int height() const { return sphaera_machine_height(p.get()); }
    std::string profile() const { return sphaera_machine_profile(p.get()); }
    std::string warning() const { return sphaera_machine_warning(p.get()); }
    std::string why() const { return sphaera_machine_why(p.get()); }
    double tree_cost() const { return sphaera_machine_tree_cost(p.get()); }
    std::string core() const { return sphaera_machine_core(p.get()); }
    std::vector<sphaera_record> records() const {
        return detail::rows<sphaera_record>(sphaera_machine_record, p.get());
    }
    std::vector<sphaera_parameter> parameters() const {
        return detail::rows<sphaera_parameter>(sphaera_machine_parameter, p.get());
    }
    std::vector<int32_t> registers() const {
        const int32_t *words = sphaera_machine_registers(p.get());
        return std::vector<int32_t>(words, words + sphaera_registers());
    }
    std::vector<uint32_t> memory() const {
        uint32_t lines;
        const uint32_t *words = sphaera_machine_memory(p.get(), &lines);
        return std::vector<uint32_t>(words, words + 8 * static_cast<size_t>(lines));
    }
    Frame render(const RenderOptions &options = RenderOptions()) const {
        return Frame(detail::make<sphaera_frame>(
            sphaera_render_with, p.get(), static_cast<const sphaera_render_options *>(&options)));
    }
    sphaera_hit trace(const double origin[3], const double direction[3]) const {
        sphaera_hit hit;
        detail::call(sphaera_trace, p.get(), origin, direction, &hit);
        return hit;
    }
    // Rays [n][3] in the scene's frame, or in integers as hardware has them.
    Hits trace(const std::vector<double> &origins, const std::vector<double> &directions,
               int threads = 0) const {
        return traced(sphaera_trace_rays, origins, directions, threads);
    }
    Hits trace(const std::vector<int32_t> &origins, const std::vector<int32_t> &directions,
               int threads = 0) const {
        return traced(sphaera_trace_grid, origins, directions, threads);
    }
    void primary(int x, int y, int32_t origin[3], int32_t direction[3]) const {
        detail::call(sphaera_primary, p.get(), x, y, origin, direction);
    }
    Pixel pixel(int x, int y) const {
        detail::Handle<sphaera_pixel, sphaera_pixel_free> of(
            detail::make<sphaera_pixel>(sphaera_pixel_trace, p.get(), x, y));
        Pixel all;
        all.rays = detail::rows<sphaera_ray>(sphaera_pixel_ray, of.get());
        for (const sphaera_stage &s : detail::rows<sphaera_stage>(sphaera_pixel_stage, of.get())) {
            int number = static_cast<int>(all.stages.size());
            Stage stage = {s, {}, sphaera_pixel_text(of.get(), number)};
            sphaera_operand operand;
            for (int i = 0; !sphaera_pixel_operand(of.get(), number, i, &operand); i++)
                stage.operands.push_back(operand);
            all.stages.push_back(std::move(stage));
        }
        return all;
    }
    const sphaera_machine *get() const { return p.get(); }

  private:
    friend class Scene;
    explicit Machine(sphaera_machine *machine) : p(machine) {}
    template <class T, class F>
    Hits traced(F function, const std::vector<T> &origins, const std::vector<T> &directions,
                int threads) const {
        if (origins.size() != directions.size() || origins.size() % 3)
            throw Error("origins and directions have three numbers for each ray");
        Hits all;
        size_t n = origins.size() / 3;
        all.id.resize(n), all.key.resize(n), all.inside.resize(n);
        all.visits.resize(n), all.distance.resize(n);
        const sphaera_hits to = {all.id.data(), all.key.data(), all.inside.data(),
                                 all.visits.data(), all.distance.data()};
        detail::call(function, p.get(), n, origins.data(), directions.data(), threads, &to);
        return all;
    }
    detail::Handle<sphaera_machine, sphaera_machine_free> p;
};

class Scene {
  public:
    static Scene read(const std::string &path, const ReadOptions &options = ReadOptions()) {
        return Scene(
            detail::make<sphaera_scene>(sphaera_scene_read_with, path.c_str(),
                                        static_cast<const sphaera_read_options *>(&options)));
    }
    static Scene parse(const std::string &text, const std::string &name = "memory.nff",
                       uint32_t at = 0) {
        return Scene(detail::make<sphaera_scene>(sphaera_scene_parse, text.data(), text.size(),
                                                 name.c_str(), at));
    }
    static Scene parse(const std::string &text, const std::string &name,
                       const ReadOptions &options) {
        return Scene(detail::make<sphaera_scene>(
            sphaera_scene_parse_with, text.data(), text.size(), name.c_str(),
            static_cast<const sphaera_read_options *>(&options)));
    }
    static Scene make(const Arrays &arrays) {
        return Scene(detail::make<sphaera_scene>(sphaera_scene_make,
                                                 static_cast<const sphaera_arrays *>(&arrays)));
    }
    void write(const std::string &path) const {
        detail::call(sphaera_scene_write, p.get(), path.c_str());
    }
    uint32_t spheres() const { return sphaera_scene_spheres(p.get()); }
    uint32_t facets() const { return sphaera_scene_facets(p.get()); }
    std::vector<sphaera_record> records() const {
        return detail::rows<sphaera_record>(sphaera_scene_record, p.get());
    }
    Machine build(const BuildOptions &options = BuildOptions()) const {
        return Machine(detail::make<sphaera_machine>(
            sphaera_build, p.get(), static_cast<const sphaera_build_options *>(&options)));
    }
    // A machine of this scene with the tree of another one's.
    Machine refit(const Machine &machine, sphaera_progress progress = nullptr,
                  void *user = nullptr) const {
        return Machine(
            detail::make<sphaera_machine>(sphaera_refit, p.get(), machine.get(), progress, user));
    }
    Price price(const BuildOptions &options = BuildOptions(), double keep_pixels = 0,
                double keep_psnr = 0, uint32_t most = 0) const {
        detail::Handle<sphaera_price, sphaera_price_free> of(detail::make<sphaera_price>(
            sphaera_price_measure, p.get(), static_cast<const sphaera_build_options *>(&options),
            keep_pixels, keep_psnr, most));
        Price all = {{}, sphaera_price_best(of.get())};
        for (sphaera_price_row row : detail::rows<sphaera_price_row>(sphaera_price_get, of.get())) {
            PriceRow told = {row.name, row.why ? row.why : "", row};
            told.row.name = told.row.why = nullptr;
            all.rows.push_back(std::move(told));
        }
        return all;
    }
    const sphaera_scene *get() const { return p.get(); }

  private:
    explicit Scene(sphaera_scene *scene) : p(scene) {}
    detail::Handle<sphaera_scene, sphaera_scene_free> p;
};

} // namespace sphaera

#endif
