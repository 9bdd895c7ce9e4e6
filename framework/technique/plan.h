#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// A part of a technique's work that a scene may not need.
struct Stage {
    /// How sure it is that leaving it out does no harm: `exact`, not a bit changes; `bounded`, by
    /// no more than `bound`; `heuristic`, measured only.
    enum Kind { exact, bounded, heuristic };
    std::string name;
    bool needed = true;
    Kind kind = exact;
    std::string why;
    float bound = 0;
    std::uint64_t work = 0;   ///< after a run: how often it was at work in a frame
    std::string worked_on{};  ///< what was counted: "points", "rays"…; "" where nothing was
};

std::string_view to_string(Stage::Kind kind);

/// What a technique will do with a scene, found by looking at scene, camera and settings.
struct Plan {
    bool applies = true;
    std::string why;  ///< why it does not apply, or what it costs or gains
    std::vector<Stage> stages;

    /// Whether a stage is to be run. An unknown name is a programmer's mistake.
    [[nodiscard]] bool needed(std::string_view stage) const;
    /// Forces every stage on (--no-skip).
    void need_all();
    /// Forces one on. Throws Error that lists the nearest names.
    void need(std::string_view stage);
};

}  // namespace luch
