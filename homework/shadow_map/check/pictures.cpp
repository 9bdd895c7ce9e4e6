#include "homework/shadow_map/check/pictures.h"

namespace luch::homework::shadow_map {
std::vector<grading::NamedPicture> handout_pictures(const std::filesystem::path&) {
    return {};
}
}  // namespace luch::homework::shadow_map
