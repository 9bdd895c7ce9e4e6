#include "homework/ldr/check/samples.h"

#include "homework/ldr/check/store.h"

namespace luch::homework::ldr {

std::vector<Sample> stored_samples(const std::filesystem::path& root) {
    std::vector<Sample> samples;
    for (const char* name : sample_names) {
        samples.push_back(read_sample(root / "homework/ldr/reference" / name, name));
    }
    return samples;
}

}  // namespace luch::homework::ldr
