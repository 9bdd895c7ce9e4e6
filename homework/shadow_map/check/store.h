#pragma once

#include "framework/grading/stored.h"
#include "homework/shadow_map/check/samples.h"

// How a sample lies in files: one-channel EXR; lists are a row an element, the faces of a cube
// stand in two rows of three.
namespace luch::homework::shadow_map {

std::vector<grading::StoredPlane> planes_of(const Sample& sample);

/// Fills all but name, scene and the map's n from the files of a folder. Throws Error.
void read_planes(const std::filesystem::path& folder, Sample& sample);

/// Faces beside one another: 0, 1, 2 above 3, 4, 5.
template <class T>
Image<T> sheet_of(const std::array<Image<T>, faces_of_cube>& faces) {
    const int n = faces[0].width();
    Image<T> sheet({3 * n, 2 * n});
    for (int face = 0; face < faces_of_cube; ++face) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                sheet(face % 3 * n + x, face / 3 * n + y) =
                    faces[static_cast<std::size_t>(face)](x, y);
            }
        }
    }
    return sheet;
}

}  // namespace luch::homework::shadow_map
