#include "framework/technique/catalogue.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

namespace luch {

const TechniqueInfo& find_technique(std::string_view name) {
    std::vector<std::string_view> names;
    for (const TechniqueInfo& info : catalogue()) {
        if (info.name == name) return info;
        names.push_back(info.name);
    }
    throw Error("there is no technique \"" + std::string(name) + "\"; " +
                did_you_mean(name, names) + " `luch list` shows all of them");
}

}  // namespace luch
