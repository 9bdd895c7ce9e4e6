#pragma once

#include "framework/scene/scene.h"

#include <vector>

namespace luch {

/// Finds directions from which the sky sends much light. A sky of one colour is sampled by the
/// cosine with the surface's normal. A cube map is cut into cells of one pixel (of several, where a
/// side has more than 513), each chosen by the brightness of the pixels around it times the solid
/// angle that it covers, and filled evenly: every direction from which light comes can be found.
class SkySampler {
 public:
    explicit SkySampler(const Scene& scene);

    /// Nothing to be sampled: no light comes from the sky.
    [[nodiscard]] bool black() const { return black_; }

    struct Sample {
        Vec3d direction;  ///< unit length
        double pdf = 0;   ///< over solid angle
    };
    /// Only when the sky is not black.
    [[nodiscard]] Sample sample(const Vec3d& normal, const Vec2d& square) const;
    [[nodiscard]] double pdf(const Vec3d& normal, const Vec3d& direction) const;

 private:
    /// The cells of one side of the cube.
    struct Grid {
        int columns = 0, rows = 0;
        std::size_t first_row = 0;   ///< in row_sums_
        std::size_t first_cell = 0;  ///< in cell_sums_; a row has columns + 1 of them, from 0 to 1
    };
    void add_side(const Image<Rgb>& pixels, std::vector<double>& row_weights);
    [[nodiscard]] double cell_pdf(const Grid& grid, int column, int row, const CubePoint& at) const;

    bool black_ = true;
    bool constant_ = true;
    std::vector<Grid> grids_;        ///< by CubePoint::Side
    std::vector<double> row_sums_;   ///< of all rows of all sides: chances, added up
    std::vector<double> cell_sums_;  ///< within each row
};

}  // namespace luch
