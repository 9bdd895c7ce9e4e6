#include "framework/grading/stored.h"

#include "framework/grading/gates.h"
#include "framework/image/planes.h"

#include <fmt/format.h>

#include <cstring>

namespace luch::grading {
namespace {

/// How many numbers differ in their bits (a NaN is what it is); all of them when the kind or the
/// size does.
std::size_t differences(const Plane32& one, const Plane32& other) {
    return std::visit(
        [](const auto& a, const auto& b) -> std::size_t {
            if constexpr (std::is_same_v<decltype(a), decltype(b)>) {
                if (a.size() != b.size()) return a.size().area();
                std::size_t count = 0;
                for (std::size_t i = 0; i < a.pixels().size(); ++i) {
                    count += std::memcmp(&a.pixels()[i], &b.pixels()[i], sizeof b.pixels()[i]) != 0;
                }
                return count;
            } else {
                return a.size().area();
            }
        },
        one, other);
}

Size size_of(const Plane32& plane) {
    return std::visit([](const auto& image) { return image.size(); }, plane);
}

Image<Rgb> picture_of(const Plane32& plane) {
    const auto* depths = std::get_if<Image<float>>(&plane);
    return depths != nullptr ? depth_greys(depths->view())
                             : id_colours(std::get<Image<std::uint32_t>>(plane).view());
}

}  // namespace

bool regenerate_plane(const std::filesystem::path& folder, const StoredPlane& made, Size frame,
                      const Regeneration& regeneration) {
    const std::filesystem::path file = folder / made.name;
    const bool floats = std::holds_alternative<Image<float>>(made.plane);
    if (std::filesystem::exists(file)) {
        const Plane32 old = floats ? Plane32(read_float_plane(file)) : Plane32(read_id_plane(file));
        const std::size_t count = differences(made.plane, old);
        if (count == 0) return false;
        regeneration.say(fmt::format("{}: {} numbers differ", file.string(), count));
        if (size_of(old) == frame && size_of(made.plane) == frame) {
            regeneration.show(file, picture_of(old), picture_of(made.plane));
        }
    } else {
        regeneration.say(fmt::format("{}: new", file.string()));
    }
    if (!regeneration.consent) return true;
    std::filesystem::create_directories(folder);
    std::visit([&](const auto& plane) { write_plane(file, plane.view()); }, made.plane);
    return true;
}

}  // namespace luch::grading
