#pragma once

#include <string>
#include <vector>

namespace luch::assets {

/// A named part of the Cornell box as the text of an OBJ file.
struct BoxPart {
    std::string name;
    std::string obj;
};

/// The box, its walls by colour, and the two blocks in it.
std::vector<BoxPart> cornell_parts();

}  // namespace luch::assets
