#include "framework/trace/counts.h"

#include <numeric>

namespace luch {

std::uint64_t Counts::all_rays() const {
    return std::accumulate(rays.begin(), rays.end(), std::uint64_t{0});
}

std::uint64_t Counts::of(Part part) const {
    return part == Part::scene_tree ? work.searches : parts[static_cast<std::size_t>(part)];
}

Counts& Counts::operator+=(const Counts& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] += other.parts[i];
    object_tests += other.object_tests;
    shades += other.shades;
    fallbacks += other.fallbacks;
    cells += other.cells;
    work += other.work;
    return *this;
}

}  // namespace luch
