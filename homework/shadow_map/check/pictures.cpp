#include "homework/shadow_map/check/pictures.h"

#include "framework/scene/loader/loader.h"
#include "framework/trace/surface.h"
#include "homework/shadow_map/check/store.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

constexpr Size panel{212, 159};
const Rgb white(1), red(0.85f, 0.05f, 0.02f);

Image<Rgb> in_a_row(const std::vector<Image<Rgb>>& images) {
    constexpr int gap = 6;
    int width = -gap;
    for (const auto& image : images) width += image.width() + gap;
    Image<Rgb> row({width, images.front().height()}, white);
    int x0 = 0;
    for (const auto& image : images) {
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) row(x0 + x, y) = image(x, y);
        }
        x0 += image.width() + gap;
    }
    return row;
}

CubeMap map_around(const Vec3d& light, int n, Tracer& tracer) {
    CubeMap map{n, {}};
    for (int face = 0; face < faces_of_cube; ++face) {
        Face& whole = map.faces[static_cast<std::size_t>(face)];
        whole = whole_face(n, 0);
        reference().render_face(light, face, n, whole.window, tracer, whole.distance.view());
    }
    return map;
}

/// A scene of the homework, seen by its camera.
class View {
 public:
    View(const std::filesystem::path& root, const std::string& name)
        : scene_(load_scene(root / ("homework/shadow_map/scenes/" + name + ".scene")).scene),
          accelerator_(build_accelerator(scene_)),
          tracer_(*accelerator_) {
        const Screen screen(scene_.camera, panel);
        for (std::uint32_t i = 0; i < panel.area(); ++i) {
            const int x = static_cast<int>(i) % panel.width, y = static_cast<int>(i) / panel.width;
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            const Hit hit = tracer_.closest(RayKind::primary, ray);
            if (!hit) continue;
            const auto* lambert = std::get_if<Lambert>(&material_of(scene_, hit));
            if (lambert == nullptr) continue;
            pixels_.push_back(i);
            surfaces_.push_back(surface_at(scene_, ray, hit));
            albedos_.push_back(lambert->color);
        }
    }

    [[nodiscard]] Vec3d light() const { return find_light<PointLight>(scene_)->position; }
    [[nodiscard]] const RectLight& area() const { return *find_light<RectLight>(scene_); }
    Tracer& tracer() { return tracer_; }

    [[nodiscard]] std::vector<Receiver> receivers(const Vec3d& light) const {
        std::vector<Receiver> all;
        for (const Surface& surface : surfaces_) {
            all.push_back({Vec3(surface.position - light), Vec3(surface.geometric_normal)});
        }
        return all;
    }

    /// What shadow rays say.
    std::vector<float> by_rays(const Vec3d& light) {
        std::vector<float> shares;
        for (const Surface& surface : surfaces_) {
            const Ray ray = shadow_ray(surface, light);
            shares.push_back(tracer_.occluded(RayKind::shadow, ray) ? 0.0f : 1.0f);
        }
        return shares;
    }

    /// Adds what a light of so much power sends to each surface.
    void add(const Vec3d& light, float power, std::span<const float> shares,
             std::vector<Rgb>& sums) const {
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            const Vec3d way = light - surfaces_[i].position;
            const double squared = glm::dot(way, way);
            const double cosine = glm::dot(surfaces_[i].normal, way) / std::sqrt(squared);
            if (cosine <= 0) continue;
            sums[i] += albedos_[i] * (power * shares[i] * static_cast<float>(cosine / squared));
        }
    }

    [[nodiscard]] std::vector<Rgb> ambient() const {
        std::vector<Rgb> sums;
        for (const Rgb& albedo : albedos_) sums.push_back(0.12f * albedo);
        return sums;
    }

    [[nodiscard]] Image<Rgb> picture(const std::vector<Rgb>& colours) const {
        Image<Rgb> image(panel, scene_.settings.background);
        for (std::size_t i = 0; i < colours.size(); ++i) image.pixels()[pixels_[i]] = colours[i];
        // Few different levels: a small file.
        for (Rgb& pixel : image.pixels()) {
            for (int k = 0; k < 3; ++k) {
                pixel[k] = std::round(std::sqrt(std::min(pixel[k], 1.0f)) * 40) / 40;
                pixel[k] *= pixel[k];
            }
        }
        return image;
    }

    [[nodiscard]] Image<Rgb> lit_by(const Vec3d& light, float power,
                                    std::span<const float> shares) const {
        std::vector<Rgb> sums = ambient();
        add(light, power, shares, sums);
        return picture(sums);
    }

 private:
    Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    Tracer tracer_;
    std::vector<std::uint32_t> pixels_;
    std::vector<Surface> surfaces_;
    std::vector<Rgb> albedos_;
};

/// What lit or pcf say with a map of that size and so many times the bias.
std::vector<float> by_map(View& view, const Vec3d& light, int n, decltype(Steps::lit) filter,
                          float times) {
    const CubeMap map = map_around(light, n, view.tracer());
    const std::vector<Receiver> receivers = view.receivers(light);
    std::vector<float> biases(receivers.size()), shares(receivers.size());
    reference().bias(receivers, n, biases);
    for (float& bias : biases) bias *= times;
    filter(map, receivers, biases, shares);
    return shares;
}

/// t1: the faces in colours, their texels as a chessboard.
Image<Rgb> texels(const std::filesystem::path& root) {
    constexpr int n = 24;
    const Rgb colours[] = {{0.85f, 0.2f, 0.15f}, {0.45f, 0.08f, 0.06f}, {0.2f, 0.65f, 0.2f},
                           {0.08f, 0.3f, 0.1f},  {0.2f, 0.35f, 0.9f},   {0.07f, 0.12f, 0.4f}};
    std::vector<Image<Rgb>> panels;
    for (const char* name : {"columns", "stack"}) {
        const View view(root, name);
        std::vector<Vec3> directions;
        for (const Receiver& each : view.receivers(view.light())) {
            directions.push_back(each.from_light);
        }
        std::vector<Texel> found(directions.size());
        reference().texel_of(directions, n, found);
        std::vector<Rgb> seen;
        for (const auto& [face, x, y] : found) {
            seen.push_back(colours[face] * ((x + y) % 2 == 0 ? 1.0f : 0.55f));
        }
        panels.push_back(view.picture(seen));
    }
    return in_a_row(panels);
}

/// t3: what the light sees, near things bright.
Image<Rgb> faces(const std::filesystem::path& root) {
    constexpr int n = 105, gap = 5;
    View view(root, "columns");
    const CubeMap map = map_around(view.light(), n, view.tracer());
    Image<Rgb> image({3 * n + 2 * gap, 2 * n + gap}, white);
    for (int face = 0; face < faces_of_cube; ++face) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const float distance = map.at({face, x, y});
                const float grey = std::isfinite(distance) ? std::min(1.0f, 1.2f / distance) : 0;
                const float level = std::round(grey * 60) / 60;
                image(face % 3 * (n + gap) + x, face / 3 * (n + gap) + y) =
                    std::isfinite(distance) ? Rgb(level * level) : Rgb(0.02f, 0.05f, 0.16f);
            }
        }
    }
    return image;
}

/// t4: none, the right one, far too much.
Image<Rgb> biases(const std::filesystem::path& root) {
    View view(root, "stack");
    std::vector<Image<Rgb>> panels;
    for (const float times : {0.0f, 1.01f, 20.0f}) {
        const auto shares = by_map(view, view.light(), 64, reference().lit, times);
        panels.push_back(view.lit_by(view.light(), 9, shares));
    }
    return in_a_row(panels);
}

/// t5 and t6: one answer, the mean of nine, rays.
Image<Rgb> filters(const std::filesystem::path& root) {
    View view(root, "columns");
    const Vec3d light = view.light();
    return in_a_row(
        {view.lit_by(light, 9, by_map(view, light, 48, reference().lit, 1.01f)),
         view.lit_by(light, 9, by_map(view, light, 48, reference().pcf, 1.01f * pcf_width)),
         view.lit_by(light, 9, view.by_rays(light))});
}

/// t7: where the points lie.
Image<Rgb> patterns() {
    constexpr int side = 132, n = 12;
    std::vector<Image<Rgb>> panels;
    for (const Pattern pattern : {Pattern::regular, Pattern::jittered, Pattern::random}) {
        Image<Rgb> image({side, side}, Rgb(0.8f));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (x % (side / 4) == 0 || y % (side / 3) == 0) image(x, y) = Rgb(0.45f);
            }
        }
        std::vector<LightPoint> points;
        reference().light_points({}, n, pattern, Key(4), points);
        for (const LightPoint& point : points) {
            const Vec2d at = (Vec2d(point.position.x, point.position.z) + 0.5) * double(side);
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    if (glm::distance(Vec2d(x + 0.5, y + 0.5), at) < 3.2) image(x, y) = red;
                }
            }
        }
        panels.push_back(std::move(image));
    }
    return in_a_row(panels);
}

/// t7: a light of many points.
Image<Rgb> many_points(const std::filesystem::path& root) {
    View view(root, "stack");
    std::vector<Image<Rgb>> panels;
    for (const Pattern pattern : {Pattern::regular, Pattern::jittered}) {
        std::vector<LightPoint> points;
        reference().light_points(view.area(), 9, pattern, Key(4), points);
        std::vector<Rgb> sums = view.ambient();
        for (const LightPoint& point : points) {
            const auto shares =
                by_map(view, point.position, 160, reference().pcf, 1.01f * pcf_width);
            view.add(point.position, 60 * point.share, shares, sums);
        }
        panels.push_back(view.picture(sums));
    }
    return in_a_row(panels);
}

}  // namespace

std::vector<grading::NamedPicture> handout_pictures(const std::filesystem::path& root) {
    return {{"t1", texels(root)},  {"t3", faces(root)}, {"t4", biases(root)},
            {"t6", filters(root)}, {"t7", patterns()},  {"t7_light", many_points(root)}};
}

}  // namespace luch::homework::shadow_map
