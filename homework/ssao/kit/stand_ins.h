#pragma once

#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// Whether these are the depths of one of the homework's own scenes, at its own camera and size.
/// There, reference() knows positions, normals and, for the radius of the tests, occlusion.
bool is_public(const Image<float>& depth);

}  // namespace luch::techniques::ssao
