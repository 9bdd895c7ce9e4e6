#include "homework/ssao/check/others.h"
namespace luch::homework::ssao {
std::vector<grading::Other> mutants() {
    return {};
}
}  // namespace luch::homework::ssao
