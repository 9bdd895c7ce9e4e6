#include "techniques/ldr/render.h"

#include "techniques/ldr/planes.h"

#include <algorithm>
#include <limits>

namespace luch::techniques::ldr {
namespace {

/// Calls work(x, y, slot) for the pixels of a tile, row by row.
template <class Work>
void for_each_slot(const Tile& tile, Work&& work) {
    std::size_t slot = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) work(x, y, slot++);
    }
}

/// The noise of a pixel, the same in every frame: what is still does not shimmer.
std::uint8_t noise(int x, int y) {
    constexpr std::uint64_t dithering = 0x1d7;
    const auto place = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
    return static_cast<std::uint8_t>(Key(dithering).bits(place) >> 56);
}

}  // namespace

template <class Canvas>
Misfits Renderer<Canvas>::render() {
    workers_.assign(static_cast<std::size_t>(job_.context.workers()), Worker(job_.look));
    if (keeps_) kept_ = Image<Sum>(job_.shot.size);
    not_numbers_ = Image<std::uint8_t>(job_.shot.size, 0);
    for_each_tile([&](const Tile& tile, Worker& worker, Tracer& tracer) {
        first_pass(tile, worker, tracer);
    });
    Image<std::uint8_t> edges(job_.shot.size, 0);
    if (antialiases_) {
        edges = edges_of(job_.frame.colour.view(), job_.context);
        for_each_tile([&](const Tile& tile, Worker& worker, Tracer& tracer) {
            tracer.counts().did(Part::anti_aliasing, tile.area());
            antialias_pass(tile, worker, tracer, edges.view());
        });
    }
    if (job_.toned) tone_pass(edges);
    Misfits all;
    for (const Worker& worker : workers_) {
        all.not_a_number += worker.canvas.misfits().not_a_number;
        all.too_bright += worker.canvas.misfits().too_bright;
    }
    return all;
}

template <class Canvas>
void Renderer<Canvas>::for_each_tile(
    const std::function<void(const Tile&, Worker&, Tracer&)>& work) {
    job_.context.for_each_tile(job_.shot.size, [&](Tile tile, int index) {
        Worker& worker = workers_[static_cast<std::size_t>(index)];
        worker.pixels.parts.use(job_.textures);
        fill_patterns(tile, worker);
        work(tile, worker, job_.context.tracer(index));
    });
}

template <class Canvas>
void Renderer<Canvas>::first_pass(const Tile& tile, Worker& worker, Tracer& tracer) {
    worker.canvas.start(tile.area());
    for_each_slot(tile, [&](int x, int y, std::size_t) { not_numbers_(x, y) = 0; });
    for (int sample = 0; sample < samples_; ++sample) {
        defer_tile(job_.scene, job_.shot, tile, sample, needs_, tracer, worker.pixels);
        find_slots(tile, worker);
        mark_not_numbers(worker);
        worker.canvas.add(worker.pixels, worker.slots, sample, samples_, worker.up);
        if (sample == 0 && job_.context.budget().planes)
            draw_planes(worker.pixels, job_.look, job_.frame);
    }
    if (keeps_) keep(tile, worker);
    develop(tile, worker, samples_);
}

template <class Canvas>
void Renderer<Canvas>::antialias_pass(const Tile& tile, Worker& worker, Tracer& tracer,
                                      ImageView<const std::uint8_t> edges) {
    std::vector<std::uint8_t> here(tile.area());
    for_each_slot(tile, [&](int x, int y, std::size_t slot) { here[slot] = edges(x, y); });
    if (std::ranges::count(here, 1) == 0) return;
    constexpr int all = antialias_samples + 1;
    load(tile, worker);
    worker.canvas.share(all);
    for (int sample = 0; sample < antialias_samples; ++sample) {
        defer_edges(job_.scene, job_.shot, tile, sample, edges, needs_, tracer, worker.pixels);
        find_slots(tile, worker);
        mark_not_numbers(worker);
        worker.canvas.add(worker.pixels, worker.slots, sample + 1, all, worker.up);
    }
    if (job_.toned) {
        const std::vector<Sum> more = worker.canvas.sums();
        for_each_slot(tile, [&](int x, int y, std::size_t slot) {
            if (here[slot] != 0) kept_(x, y) = more[slot];
        });
    }
    develop(tile, worker, all, here.data());
}

template <class Canvas>
void Renderer<Canvas>::tone_pass(const Image<std::uint8_t>& edges) {
    const auto count = [&](std::uint8_t edge) {
        return edge != 0 ? antialias_samples + 1 : samples_;
    };
    // Small and quick beside the rays: one thread.
    Worker& worker = workers_[0];
    const Tile whole = job_.frame.colour.view().tile();
    load(whole, worker);
    double white = 0;
    for (std::size_t i = 0; i < whole.area(); ++i) {
        const double brightest = worker.canvas.brightest(i, count(edges.pixels()[i]));
        if (not_numbers_.pixels()[i] == 0) white = std::max(white, brightest);
    }
    if (white <= 1) return;
    for (std::size_t i = 0; i < whole.area(); ++i) {
        worker.canvas.tone(i, count(edges.pixels()[i]), white);
    }
    fill_patterns(whole, worker);
    std::vector<std::uint8_t> others(edges.pixels());
    for (std::uint8_t& each : others) each = each == 0 ? 1 : 0;
    develop(whole, worker, samples_, others.data());
    if (antialiases_) develop(whole, worker, antialias_samples + 1, edges.pixels().data());
    job_.context.did("tone mapping", whole.area(), "pixels");
}

template <class Canvas>
void Renderer<Canvas>::find_slots(const Tile& tile, Worker& worker) const {
    worker.slots.clear();
    for (const auto& [x, y] : worker.pixels.pixels) {
        worker.slots.push_back(
            static_cast<std::uint32_t>((y - tile.y0) * tile.width() + (x - tile.x0)));
    }
}

template <class Canvas>
void Renderer<Canvas>::fill_patterns(const Tile& tile, Worker& worker) const {
    worker.dither.assign(tile.area(), 128);
    worker.up.resize(tile.area());
    for_each_slot(tile, [&](int x, int y, std::size_t slot) {
        worker.up[slot] = static_cast<std::uint8_t>((x + y) & 1);
        if (job_.dither) worker.dither[slot] = noise(x, y);
    });
}

template <class Canvas>
void Renderer<Canvas>::load(const Tile& tile, Worker& worker) const {
    worker.canvas.start(tile.area());
    for_each_slot(
        tile, [&](int x, int y, std::size_t slot) { worker.canvas.sums()[slot] = kept_(x, y); });
}

template <class Canvas>
void Renderer<Canvas>::keep(const Tile& tile, Worker& worker) {
    for_each_slot(
        tile, [&](int x, int y, std::size_t slot) { kept_(x, y) = worker.canvas.sums()[slot]; });
}

/// A word cannot say that it is no number, so the frame does: counted, never hidden.
template <class Canvas>
void Renderer<Canvas>::mark_not_numbers(Worker& worker) {
    for (std::size_t i = 0; i < worker.pixels.light.size(); ++i) {
        const auto& [x, y] = worker.pixels.pixels[i];
        const Rgb& light = worker.pixels.light[i];
        if (std::isnan(light.r + light.g + light.b)) not_numbers_(x, y) = 1;
    }
}

template <class Canvas>
void Renderer<Canvas>::develop(const Tile& tile, Worker& worker, int n, const std::uint8_t* edges) {
    worker.colours.resize(tile.area());
    worker.alpha.resize(tile.area());
    worker.canvas.resolve(n, worker.dither, worker.colours, worker.alpha);
    auto& coverage = job_.frame.plane<float>("coverage", PlaneKind::scalar);
    for_each_slot(tile, [&](int x, int y, std::size_t slot) {
        if (edges != nullptr && edges[slot] == 0) return;
        const bool number = not_numbers_(x, y) == 0;
        job_.frame.colour(x, y) =
            number ? worker.colours[slot] : Rgb(std::numeric_limits<float>::quiet_NaN());
        coverage(x, y) = static_cast<float>(worker.alpha[slot]) / 255;
    });
}

template class Renderer<WordCanvas>;
template class Renderer<WideCanvas>;
template class Renderer<LevelCanvas>;

}  // namespace luch::techniques::ldr
