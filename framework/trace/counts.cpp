#include "framework/trace/counts.h"

#include <numeric>

namespace luch {

std::uint64_t Counts::all_rays() const {
    return std::accumulate(rays.begin(), rays.end(), std::uint64_t{0});
}

Counts& Counts::operator+=(const Counts& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    object_tests += other.object_tests;
    shades += other.shades;
    fallbacks += other.fallbacks;
    cells += other.cells;
    work += other.work;
    return *this;
}

}  // namespace luch
