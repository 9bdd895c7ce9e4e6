#include "tests/testing/kernel_objects.h"

namespace luch {
namespace {

TEST(RasterKernels, ExportTheirEntryAndNothingThatALinkerMightShare) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers add symbols of their own";
#endif
    testing::expect_one_entry_each(LUCH_KERNEL_OBJECTS "/luch_raster_", ".dir/kernel.cpp.o",
                                   "luch::raster::kernels_");
}

}  // namespace
}  // namespace luch
