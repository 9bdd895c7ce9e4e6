#include "techniques/ldr/planes.h"

namespace luch::techniques::ldr {
namespace {

Rgb in_word(const Rgb& light) {
    return Rgb(byte_of(light.r), byte_of(light.g), byte_of(light.b)) / 255.0f;
}

bool above_white(const Rgb& light) {
    return light.r > 1 || light.g > 1 || light.b > 1;
}

Image<Rgb>& colours(Frame& frame, const char* name) {
    return frame.plane<Rgb>(name, PlaneKind::colour);
}

}  // namespace

void make_planes(Frame& frame) {
    for (const char* name : {"albedo", "light", "others"}) colours(frame, name);
    frame.plane<std::uint8_t>("too bright", PlaneKind::mask);
    frame.plane<float>("coverage", PlaneKind::scalar);
}

void draw_planes(const DeferredPixels& pixels, const Look& look, Frame& frame) {
    using Kind = ShadedParts::Kind;
    Image<Rgb>&albedo = colours(frame, "albedo"), &lit = colours(frame, "light"),
    &others = colours(frame, "others");
    auto& too_bright = frame.plane<std::uint8_t>("too bright", PlaneKind::mask);
    for (std::size_t i = 0; i < pixels.light.size(); ++i) {
        const auto& [x, y] = pixels.pixels[i];
        const bool is_lit = pixels.parts.kinds()[i] == Kind::lit;
        Rgb sum = is_lit ? look.ambient : Rgb(0), rest = is_lit ? Rgb(0) : pixels.light[i];
        for (const auto& light : pixels.parts.lights()) {
            if (!light.diffuse.empty()) sum += light.diffuse[i];
            if (!light.highlight.empty()) rest += light.highlight[i];
        }
        albedo(x, y) = in_word(pixels.parts.albedo()[i]);
        lit(x, y) = in_word(sum * look.exposure);
        others(x, y) = in_word(rest * look.exposure);
        const bool bright = above_white(sum * look.exposure) || above_white(rest * look.exposure);
        too_bright(x, y) = bright ? 1 : 0;
    }
}

}  // namespace luch::techniques::ldr
