#pragma once

#include "framework/technique/outcome.h"

namespace luch {

/// The colour that red-cyan glasses take apart again: red from the left eye's picture, green and
/// blue from the right's. Both are desaturated first (c ← grey + 0.3 (c − grey), grey
/// the mean of the channels), so that no thing is bright for one eye and black for the other. In
/// linear light.
Rgb anaglyph(const Rgb& left, const Rgb& right);

/// One outcome of two eyes' outcomes: the colours become an anaglyph, times and counts are added, a
/// stage is needed when it was for either eye. Planes and marks are the left eye's.
Outcome stereo_outcome(Outcome left, const Outcome& right);

}  // namespace luch
