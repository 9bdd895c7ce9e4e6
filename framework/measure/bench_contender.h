#pragma once

#include "framework/measure/bench_mix.h"
#include "framework/measure/mix/kernels.h"

#include <cstdint>
#include <functional>
#include <vector>

// What the parts of `luch bench mix` share.
namespace luch {

/// Numbers that begin where a line of the cache does, or some vectors would lie in two.
template <class T>
class Aligned {
 public:
    explicit Aligned(std::size_t n) : lines_((n * sizeof(T) + 63) / 64), size_(n) {}
    [[nodiscard]] T* data() { return reinterpret_cast<T*>(lines_.data()); }
    [[nodiscard]] const T* data() const { return reinterpret_cast<const T*>(lines_.data()); }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] T& operator[](std::size_t i) { return data()[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return data()[i]; }

 private:
    struct alignas(64) Line {
        unsigned char bytes[64];
    };
    std::vector<Line> lines_;
    std::size_t size_;
};

/// One of those that race.
struct Contender {
    MixSpeed speed;
    std::function<void(std::size_t pixels)> work;
    std::function<double()> worst_error;
    std::vector<double> frame_ns{}, again_ns{}, tile_ns{};
};

/// A frame put together from planes, and textures looked up: floats, then words. `pixels`: of the
/// frame.
std::vector<Contender> plane_contenders(const mix::Kernels& kernels, std::size_t pixels);
std::vector<Contender> texture_contenders(std::size_t pixels);

}  // namespace luch
