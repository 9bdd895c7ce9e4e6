#include "framework/raster/fill.h"
#include "framework/raster/kernels.h"
#include "framework/raster/resolve.h"

// Compiled once for every level, see luch_kernels(). The entry is all that may be seen from
// outside (tests/raster looks with nm).
namespace luch::raster {

#define LUCH_NAME_OF(level) kernels_##level
#define LUCH_NAME(level) LUCH_NAME_OF(level)

const Kernels& LUCH_NAME(LUCH_LEVEL)() {
    static constexpr Kernels all{set_up, draw, survey, miss, resolve};
    return all;
}

}  // namespace luch::raster
