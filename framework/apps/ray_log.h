#pragma once

#include "framework/apps/session.h"

#include <filesystem>

namespace luch {

/// `luch render --ray-log`: which pixel, and from where its rays are looked at.
struct RayLogOptions {
    std::string pixel;   ///< "x,y"; "": no log
    std::string camera;  ///< "x,y,z,yaw,pitch[,roll[,fov]]"; "": one is chosen

    void declare(Arguments& arguments);
    /// The pixel, to be recorded in `log`; nothing when none was asked for. Throws Error when it is
    /// none of the frame's.
    [[nodiscard]] std::optional<Watch> watch(Size frame, RayLog& log) const;
};

/// Writes NAME-rays.json (the tree), NAME-rays.png (the scene from a second camera) and
/// NAME-rays.svg (the same with the rays over it), where NAME is `picture` without its ending, and
/// says so.
void write_ray_log(const Session& session, const RayLogOptions& options, const Watch& watch,
                   const std::filesystem::path& picture);

}  // namespace luch
