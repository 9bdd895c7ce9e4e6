#pragma once

#include "framework/baseline/deferred.h"
#include "framework/technique/context.h"
#include "techniques/ldr/canvas.h"

#include <mutex>
#include <vector>

namespace luch::techniques::ldr {

/// What a frame is made from.
struct Job {
    const Scene& scene;
    const Shot& shot;
    Frame& frame;
    Context& context;
    Look look;
    const WordTextures* textures = nullptr;  ///< null: the scene's own
    bool dither = true;
    bool toned = false;
};

/// A frame, tile by tile: all samples; then the scene's own anti-aliasing; then the curve. Sums are
/// kept beyond a tile only where one of the latter two asks for them.
template <class Canvas>
class Renderer {
 public:
    explicit Renderer(const Job& job)
        : job_(job),
          needs_(needs_of(job.context.plan())),
          samples_(sample_count(job.shot)),
          antialiases_(needs_[Part::anti_aliasing] && may_antialias(job.shot)),
          keeps_(antialiases_ || job.toned) {}

    /// How many channels did not fit into words.
    Misfits render();

 private:
    using Sum = typename Canvas::Sum;
    /// What a worker uses again and again.
    struct Worker {
        explicit Worker(const Look& look) : canvas(look) {}
        Canvas canvas;
        DeferredPixels pixels;
        std::vector<std::uint32_t> slots;
        std::vector<std::uint8_t> dither, up, alpha;
        std::vector<Rgb> colours;
    };

    void first_pass(const Tile& tile, Worker& worker, Tracer& tracer);
    void antialias_pass(const Tile& tile, Worker& worker, Tracer& tracer,
                        ImageView<const std::uint8_t> edges);
    void tone_pass(const Image<std::uint8_t>& edges);
    void find_slots(const Tile& tile, Worker& worker) const;
    void fill_patterns(const Tile& tile, Worker& worker) const;
    void load(const Tile& tile, Worker& worker) const;
    void keep(const Tile& tile, Worker& worker);
    void mark_not_numbers(Worker& worker);
    /// Writes the pixels of a tile; with `edges` only those that are.
    void develop(const Tile& tile, Worker& worker, int n, const std::uint8_t* edges = nullptr);
    void for_each_tile(const std::function<void(const Tile&, Worker&, Tracer&)>& work);

    Job job_;
    Needs needs_;
    int samples_;
    bool antialiases_, keeps_;
    std::vector<Worker> workers_;
    Image<Sum> kept_;
    Image<std::uint8_t> not_numbers_;
};

extern template class Renderer<WordCanvas>;
extern template class Renderer<WideCanvas>;
extern template class Renderer<LevelCanvas>;

}  // namespace luch::techniques::ldr
