#include "framework/trace/sky_sampler.h"

#include "framework/trace/directions.h"

#include <algorithm>
#include <span>

namespace luch {
namespace {

constexpr int most_cells = 512;  ///< along a side

/// A pixel that is not finite has no weight: it must not take all of the samples.
double brightness(const Rgb& pixel) {
    const double sum = std::abs(static_cast<double>(pixel.x)) + std::abs(double(pixel.y)) +
                       std::abs(static_cast<double>(pixel.z));
    return std::isfinite(sum) ? sum : 0;
}

/// The pixels that a bilinear lookup within a cell may read, first and last.
std::pair<int, int> pixels_of(int cell, int cells, int pixels) {
    const double width = static_cast<double>(pixels - 1) / cells;
    return {static_cast<int>(cell * width),
            std::min(pixels - 1, static_cast<int>(std::ceil((cell + 1) * width)))};
}

double mean_brightness(const Image<Rgb>& pixels, std::pair<int, int> columns,
                       std::pair<int, int> rows) {
    double sum = 0;
    for (int y = rows.first; y <= rows.second; ++y) {
        for (int x = columns.first; x <= columns.second; ++x) sum += brightness(pixels(x, y));
    }
    return sum / ((columns.second - columns.first + 1.0) * (rows.second - rows.first + 1.0));
}

double coordinate(double cell, int cells) {
    return 2 * cell / cells - 1;
}

/// Solid angle for each area of the cube's side, to the power of −1.
double spread_at(double s, double t) {
    const double square = 1 + s * s + t * t;
    return square * std::sqrt(square);
}

/// Turns weights into running sums from 0 to 1; returns their sum. All 0 stays so.
double add_up(std::span<double> sums) {
    double sum = 0;
    for (double& value : sums) sum = value += sum;
    if (sum > 0) {
        for (double& value : sums) value /= sum;
        sums.back() = 1;
    }
    return sum;
}

struct Slot {
    std::size_t index;
    double inside;  ///< in [0, 1)
    double chance;
};

/// The slot that `random` falls into; `sums` begins with 0 and ends with 1. One of no chance is
/// never found.
Slot find_slot(std::span<const double> sums, double random) {
    const auto above = std::upper_bound(sums.begin(), sums.end() - 1, random);
    const auto index = static_cast<std::size_t>(above - sums.begin()) - 1;
    const double chance = sums[index + 1] - sums[index];
    return {index, (random - sums[index]) / chance, chance};
}

}  // namespace

SkySampler::SkySampler(const Scene& scene) {
    const auto* cube =
        scene.environment ? std::get_if<CubemapEnvironment>(&*scene.environment) : nullptr;
    if (cube == nullptr) {
        black_ = sky_radiance(scene, {0, 1, 0}) == Rgb(0);
        return;
    }
    constant_ = false;
    std::vector<double> row_weights{0};
    for (const Image<Rgb>& side : cube->sides) add_side(side, row_weights);
    row_sums_ = std::move(row_weights);
    black_ = !(add_up(row_sums_) > 0);
}

void SkySampler::add_side(const Image<Rgb>& pixels, std::vector<double>& row_weights) {
    Grid grid;
    grid.first_row = row_weights.size() - 1;
    grid.first_cell = cell_sums_.size();
    if (pixels.size().area() > 0) {
        grid.columns = std::clamp(pixels.width() - 1, 1, most_cells);
        grid.rows = std::clamp(pixels.height() - 1, 1, most_cells);
    }
    for (int row = 0; row < grid.rows; ++row) {
        const double t = coordinate(row + 0.5, grid.rows);
        const auto rows = pixels_of(row, grid.rows, pixels.height());
        const std::size_t begin = cell_sums_.size();
        cell_sums_.push_back(0);
        for (int column = 0; column < grid.columns; ++column) {
            const double s = coordinate(column + 0.5, grid.columns);
            const auto columns = pixels_of(column, grid.columns, pixels.width());
            cell_sums_.push_back(mean_brightness(pixels, columns, rows) / spread_at(s, t));
        }
        row_weights.push_back(add_up(std::span(cell_sums_).subspan(begin)) /
                              (static_cast<double>(grid.columns) * grid.rows));
    }
    grids_.push_back(grid);
}

double SkySampler::cell_pdf(const Grid& grid, int column, int row, const CubePoint& at) const {
    const double* rows = &row_sums_[grid.first_row + static_cast<std::size_t>(row)];
    const double* cells =
        &cell_sums_[grid.first_cell +
                    static_cast<std::size_t>(row) * (static_cast<std::size_t>(grid.columns) + 1) +
                    static_cast<std::size_t>(column)];
    const double chance = (rows[1] - rows[0]) * (cells[1] - cells[0]);
    return chance * grid.columns * grid.rows / 4 * spread_at(at.s, at.t);
}

SkySampler::Sample SkySampler::sample(const Vec3d& normal, const Vec2d& square) const {
    if (constant_) {
        const Vec3d direction = sample_cosine(normal, square);
        return {direction, cosine_pdf(glm::dot(normal, direction))};
    }
    const Slot row = find_slot(row_sums_, square.y);
    std::size_t side = 0;
    while (row.index >= grids_[side].first_row + static_cast<std::size_t>(grids_[side].rows))
        ++side;
    const Grid& grid = grids_[side];
    const std::size_t row_of_side = row.index - grid.first_row;
    const std::size_t width = static_cast<std::size_t>(grid.columns) + 1;
    const Slot cell = find_slot(
        std::span(cell_sums_).subspan(grid.first_cell + row_of_side * width, width), square.x);
    const CubePoint at{static_cast<CubePoint::Side>(side),
                       coordinate(static_cast<double>(cell.index) + cell.inside, grid.columns),
                       coordinate(static_cast<double>(row_of_side) + row.inside, grid.rows)};
    return {glm::normalize(at.direction()),
            cell_pdf(grid, static_cast<int>(cell.index), static_cast<int>(row_of_side), at)};
}

double SkySampler::pdf(const Vec3d& normal, const Vec3d& direction) const {
    if (black_) return 0;
    if (constant_) return cosine_pdf(glm::dot(normal, direction));
    const CubePoint at = cube_point(direction);
    const Grid& grid = grids_[at.side];
    if (grid.rows == 0) return 0;
    const auto cell = [](double position, int cells) {
        return std::clamp(static_cast<int>((position + 1) / 2 * cells), 0, cells - 1);
    };
    return cell_pdf(grid, cell(at.s, grid.columns), cell(at.t, grid.rows), at);
}

}  // namespace luch
