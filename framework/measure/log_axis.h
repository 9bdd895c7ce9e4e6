#pragma once

#include <string>
#include <vector>

namespace luch {

/// A logarithmic axis: values to places on the page.
class LogAxis {
 public:
    struct Tick {
        double value = 0;
        std::string label;    ///< empty: a mark without a number
        bool decade = false;  ///< a power of ten
    };

    /// Covers the values (those ≤ 0 or not finite are passed over) with some air around them, and
    /// never less than a decade. `from` and `to` are the places of its two ends.
    LogAxis(const std::vector<double>& values, double from, double to);

    [[nodiscard]] double at(double value) const;
    /// At 1…9 times powers of ten. Powers of ten have labels; on an axis of less than two decades
    /// so have 2 and 5.
    [[nodiscard]] std::vector<Tick> ticks() const;

 private:
    double least_ = -3, most_ = 0;  ///< powers of ten
    double from_, to_;
};

}  // namespace luch
