#include "framework/scene/loader/names.h"

#include "framework/base/text.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

constexpr std::string_view words[] = {"geometry", "texture", "shader", "node"};

}  // namespace

void NameTable::add(Kind kind, const Block& block, Diagnostics& diagnostics) {
    OfKind& of_kind = kinds_[static_cast<std::size_t>(kind)];
    const std::uint32_t index = of_kind.count++;
    if (kind == Kind::other || block.name.empty()) return;
    const auto [entry, is_new] = of_kind.entries.try_emplace(block.name, Entry{index, block.line});
    if (!is_new) {
        diagnostics.warn(block.line,
                         fmt::format("line {} has a {} {} already, and that one is found; rename "
                                     "one of the two",
                                     entry->second.line, words[static_cast<std::size_t>(kind)],
                                     shown(block.name)));
    }
}

std::uint32_t NameTable::find(Kind kind, const std::string& name, int line,
                              const Diagnostics& diagnostics) const {
    const auto& entries = kinds_[static_cast<std::size_t>(kind)].entries;
    if (const auto entry = entries.find(name); entry != entries.end()) return entry->second.index;

    const std::string_view wanted = words[static_cast<std::size_t>(kind)];
    std::string problem = fmt::format("there is no {} {}", wanted, shown(name));
    for (std::size_t other = 0; other < std::size(words); ++other) {
        if (kinds_[other].entries.contains(name)) {
            problem = fmt::format("{} is a {}, not a {}", shown(name), words[other], wanted);
        }
    }
    std::vector<std::string_view> candidates;
    candidates.reserve(entries.size());
    for (const auto& [candidate, entry] : entries) candidates.emplace_back(candidate);
    const auto shortened = std::string_view(name).substr(0, 64);
    diagnostics.fail(line, problem + "; " + did_you_mean(shortened, candidates));
}

std::uint32_t NameTable::find(Kind kind, Properties& block, const Property& property) const {
    return find(kind, block.text(property), property.line, block.diagnostics());
}

}  // namespace luch::loader
