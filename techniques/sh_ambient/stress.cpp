#include "techniques/sh_ambient/stress.h"
namespace luch::techniques::sh_ambient {
std::vector<StressCase> stress_cases(const TechniqueInfo&, bool) {
    return {};
}
}  // namespace luch::techniques::sh_ambient
