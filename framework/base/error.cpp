#include "framework/base/error.h"

namespace luch {

std::string to_string(const Place& place) {
    return place.line > 0 ? place.file + ":" + std::to_string(place.line) : place.file;
}

}  // namespace luch
