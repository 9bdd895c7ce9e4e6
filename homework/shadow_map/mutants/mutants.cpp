#include "homework/shadow_map/mutants/mutants.h"

namespace luch::homework::shadow_map {

std::vector<grading::Other> mutants() {
    std::vector<grading::Other> all;
    for (const auto& some : {map_mutants(), bias_mutants(), shadow_mutants(), light_mutants()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace luch::homework::shadow_map
