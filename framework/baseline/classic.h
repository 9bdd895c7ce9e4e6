#pragma once

#include "framework/technique/context.h"
#include "framework/technique/samples.h"
#include "framework/technique/technique.h"
#include "framework/trace/whitted.h"

namespace luch {

/// The stages of classic ray tracing and which of them a scene does not need. A technique that
/// shades as the baseline does starts its plan with these.
std::vector<Stage> classic_stages(const Scene& scene, const Shot& shot);

/// The same as switches for the hot code.
WhittedNeeds whitted_needs(const Plan& plan);

/// Whether the scene's own anti-aliasing has a say in a shot: the number of samples is not given,
/// and there are no lens samples, which lie all over the pixel.
bool may_antialias(const Shot& shot);

/// Fills a tile with the mean of all of a pixel's samples, hits found by tracing. `lens`: rays
/// leave from all over the lens (the plan's stage "lens"). Where there is no ray it is black.
void trace_tile(const Scene& scene, const Shot& shot, const Tile& tile, const WhittedNeeds& needs,
                bool lens, Tracer& tracer, ImageView<Rgb> colour);

/// The same with one sample a pixel, the hits of the pixels' centres being known already (from an
/// item buffer…). Bit for bit what trace_tile() makes of the same hits.
void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const WhittedNeeds& needs,
                Tracer& tracer, ImageView<const Hit> hits, ImageView<Rgb> colour);

/// The scene's own anti-aliasing, as the course has it: where a pixel or a neighbour differs from
/// the mean of the five by more than 0.1 in a displayed channel, four more samples are taken around
/// the centre. A heuristic: an edge that no pixel's centre saw stays jagged.
void antialias(const Scene& scene, const Shot& shot, const WhittedNeeds& needs, Context& context,
               ImageView<Rgb> colour);

}  // namespace luch
