#pragma once

#include <string>
#include <vector>

namespace luch::assets {

/// A file to write: its path below scenes/, with '/', and its bytes.
struct Asset {
    std::string path;
    std::string bytes;
};

/// Every generated file of scenes/. The same bytes on every run and machine.
std::vector<Asset> all_assets();

}  // namespace luch::assets
