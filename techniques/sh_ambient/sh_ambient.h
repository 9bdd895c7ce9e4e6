#pragma once

#include "framework/math/rng.h"
#include "framework/scene/environment.h"
#include "framework/technique/technique.h"
#include "techniques/sh_ambient/harmonics.h"
#include "techniques/sh_ambient/probe_grid.h"

#include <memory>
#include <span>

// Ambient light from nine numbers a colour (Ramamoorthi and Hanrahan, "An Efficient Representation
// for Irradiance Environment Maps", 2001), of the sky or at points inside the scene. README.md has
// the idea, the formulas and where it fails.
namespace luch::techniques::sh_ambient {

class Incoming;

/// Some of the samples of an estimate that has `of` in all: first ≤ i < end.
struct SampleRange {
    std::uint32_t first = 0, end = 0, of = 0;
};

/// The lecture's steps. A step reads what it likes and writes only what is named as its result;
/// any division of its spans gives the same bits.
struct Steps {
    /// The coefficients ∫ L(ω)·Y_lm(ω) dω of all light from the sky. Texels that are not finite
    /// send nothing; returns how many.
    std::uint64_t (*project)(const Environment& sky, Sh9& light);

    /// E(n) = Σ A_l·L_lm·Y_lm(n) for unit normals: what arrives at one side of a surface from all
    /// around, with nothing in between. May fall below 0, see ringing.h.
    void (*irradiance)(const Sh9& light, std::span<const Vec3> normals, std::span<Rgb> irradiance);

    /// Adds some samples of the light that comes in at each place from all around: uniform
    /// directions, spread evenly over all of the samples. Those that are not finite bring nothing.
    void (*probe)(const Incoming& incoming, std::span<const Vec3d> places, const SampleRange& range,
                  Key key, std::span<Sh9> light);

    /// How far around each place the first surface is, and how far squared, smoothed for every
    /// texel with the power `distance_sharpness` of the cosine. No distance is larger than `far`.
    void (*distances)(const Incoming& incoming, std::span<const Vec3d> places, int samples,
                      double far, Key key, std::span<DistanceMap> maps);

    /// The eight probes around each point and their weights, whose sum is 1: trilinear, and less
    /// for probes that the point is likely not to see. A point beyond the outermost probes is moved
    /// to them.
    void (*blend)(const ProbeGrid& grid, std::span<const Receiver> points, Leaks leaks,
                  std::span<Blend> blends);

    /// The light at each point: its probes', by their weights.
    void (*trilinear)(const ProbeGrid& grid, std::span<const Blend> blends, std::span<Sh9> light);
};

/// The steps as the lecture has them.
Steps reference();

/// environment: light of the sky, the same everywhere, and nothing is in its way. sampled: the same
/// by looking at the sky many times, the truth of it. probes: light that comes in inside the scene,
/// from a grid of points. traced: the same by rays from every point, the truth of it.
enum class Mode { environment, probes, sampled, traced };

/// What keeps irradiance from falling below 0. off: nothing; least: degree 1 is scaled by as little
/// as it takes; scaled: always by ringing_scale.
enum class Ringing { off, least, scaled };

/// What a user may set.
struct Params {
    int mode = 0;                                    ///< an index: Mode
    int degree = 2;                                  ///< environment: of the harmonics
    int ringing = static_cast<int>(Ringing::least);  ///< an index: Ringing
    int samples = 1024;                              ///< sampled, traced: directions a point
    int probes = 12;                                 ///< along the longest side of the grid
    int rays = 256;                                  ///< from a probe
    int bounces = 3;                                 ///< of light between surfaces
    int leaks = static_cast<int>(Leaks::distances);  ///< an index: Leaks
};

/// The technique, made of these steps; each one's holes are filled by the reference.
std::unique_ptr<Technique> make(const Steps& steps, const Params& params = {});

/// Its parameter to walk along: the degree.
extern const std::span<const double> degree_sweep;

}  // namespace luch::techniques::sh_ambient
