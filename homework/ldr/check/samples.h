#pragma once

#include "techniques/ldr/ldr.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// What the tasks of this homework are tried on: pictures of 24 × 24 pixels, and what the reference
// steps make of them.
namespace luch::homework::ldr {

using techniques::ldr::Misfits;
using techniques::ldr::Steps;
using techniques::ldr::Wide;
using techniques::ldr::Word;

inline constexpr Size sample_size{24, 24};

struct Sample {
    std::string name;

    // Inputs. `words` is what accumulate() adds to `sums`, which are those of `n` words.
    std::vector<Rgb> light;
    float exposure = 1;
    std::vector<Word> a, b;
    std::vector<std::uint8_t> alpha, up, dither;
    std::vector<Wide> sums;
    int n = 1;

    // What the reference makes of them.
    std::vector<Word> encoded, added, modulated, mixed, lerped, resolved;
    std::vector<Wide> accumulated;
    Misfits misfits;
};

/// The public ones, from homework/ldr/reference. Throws Error when a file is missing or does not
/// fit.
std::vector<Sample> stored_samples(const std::filesystem::path& root);

inline constexpr const char* sample_names[] = {"ramp", "noise", "bright", "dark"};

}  // namespace luch::homework::ldr
