#include "techniques/ssao/stress.h"
namespace luch::techniques::ssao {
std::vector<StressCase> stress_cases(const TechniqueInfo&, bool) {
    return {};
}
}  // namespace luch::techniques::ssao
