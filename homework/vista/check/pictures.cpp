#include "homework/vista/check/pictures.h"

#include "framework/grading/gates.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"
#include "homework/vista/check/make_samples.h"

#include <algorithm>
#include <cmath>

namespace luch::homework::vista {
namespace {

constexpr Size panel{264, 198};
const Rgb white(1), red(0.9f, 0.05f, 0.02f), dark(0.02f);

/// A light colour of its own for every number; white for none.
Image<Rgb> coloured(const Image<std::uint32_t>& ids) {
    Image<Rgb> image(ids.size(), white);
    for (std::size_t i = 0; i < ids.size().area(); ++i) {
        const std::uint32_t id = ids.pixels()[i];
        const Key key(id + 2);
        if (id == no_node) continue;
        image.pixels()[i] = 0.15f + 0.7f * Rgb(key.uniform(0), key.uniform(1), key.uniform(2));
    }
    return image;
}

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

Sample sample_in(const std::filesystem::path& root, const std::string& name, Size size,
                 const Steps& steps) {
    Scene scene = load_scene(root / ("homework/vista/scenes/" + name + ".scene")).scene;
    scene.settings.frame = size;
    return sample_of(name, std::make_shared<const Scene>(std::move(scene)), steps);
}

/// Which triangle is seen, by its number.
Image<std::uint32_t> seen(std::vector<Tri> triangles, const Screen& screen, Hidden hidden,
                          const Steps& steps) {
    std::vector<Tri> inside;
    for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i].node = static_cast<NodeId>(i);
    steps.clip(triangles, frustum_of(screen), inside);
    std::vector<ScreenTri> on_screen(inside.size());
    steps.project(inside, screen, on_screen);
    Image<std::uint32_t> ids(screen.size());
    Image<float> depth(screen.size());
    steps.rasterise(on_screen, ids.view().tile(), hidden, ids.view(), depth.view());
    return ids;
}

/// Triangles in shades of their node's colour.
Image<Rgb> shaded(const Image<std::uint32_t>& ids, const std::vector<Tri>& triangles) {
    Image<std::uint32_t> nodes(ids.size(), no_node);
    for (std::size_t i = 0; i < ids.size().area(); ++i) {
        if (ids.pixels()[i] != no_node) nodes.pixels()[i] = triangles[ids.pixels()[i]].node;
    }
    Image<Rgb> image = coloured(nodes);
    for (std::size_t i = 0; i < ids.size().area(); ++i) {
        if (ids.pixels()[i] == no_node) continue;
        image.pixels()[i] *= 0.45f + 0.55f * Key(ids.pixels()[i]).uniform(7);
    }
    return image;
}

/// A line between two places, 1.4 pixels wide.
void draw(Image<Rgb>& image, const Vec2d& a, const Vec2d& b, const Rgb& colour) {
    constexpr double half_width = 0.7;
    const auto pixel = [](double at, int most) {
        return static_cast<int>(std::clamp(at, 0.0, double(most)));
    };
    const Vec2d along = b - a;
    const double length_squared = std::max(glm::dot(along, along), 1e-12);
    for (int y = pixel(std::min(a.y, b.y) - 2, image.height());
         y < pixel(std::max(a.y, b.y) + 2, image.height()); ++y) {
        for (int x = pixel(std::min(a.x, b.x) - 2, image.width());
             x < pixel(std::max(a.x, b.x) + 2, image.width()); ++x) {
            const Vec2d p(x + 0.5, y + 0.5);
            const double s = std::clamp(glm::dot(p - a, along) / length_squared, 0.0, 1.0);
            const double distance = glm::length(p - a - s * along) - half_width;
            // Few different greys: a small file.
            const double share = std::clamp(std::round(2 * distance + 1) / 2, 0.0, 1.0);
            image(x, y) = glm::mix(colour, image(x, y), static_cast<float>(share));
        }
    }
}

/// t1: a sphere with ever more segments; red, what is lost of it.
Image<Rgb> round(const Steps& steps) {
    Camera camera;
    camera.fov_deg = 60;
    camera.aspect = 1;
    const Screen screen(camera, {panel.height, panel.height});
    const Vec3d centre{0, 0, 3};
    std::vector<Image<Rgb>> panels;
    for (const int n : {6, 12, 24}) {
        std::vector<Tri> triangles;
        steps.tessellate(Sphere{.centre = centre, .radius = 1}, n, triangles);
        for (Tri& triangle : triangles) triangle.node = 3;
        const Image<std::uint32_t> ids = seen(triangles, screen, Hidden::depth, steps);
        Image<Rgb> image = shaded(ids, triangles);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const double along = glm::dot(screen.ray(x + 0.5, y + 0.5).direction, centre);
                const bool hit = glm::dot(centre, centre) - along * along <= 1;
                if (hit && ids(x, y) == no_node) image(x, y) = red;
            }
        }
        panels.push_back(std::move(image));
    }
    return in_a_row(panels);
}

/// t2: the triangles of all shapes, whole and as a net.
Image<Rgb> shapes(const std::filesystem::path& root, const Steps& steps) {
    std::vector<Image<Rgb>> panels;
    for (const char* name : {"balls", "boxes"}) {
        const Sample sample = sample_in(root, name, panel, steps);
        panels.push_back(
            shaded(seen(sample.around, sample.screen(), Hidden::depth, steps), sample.around));
    }
    return in_a_row(panels);
}

/// t3: seen with a wider angle: pale, what the frame cuts off.
Image<Rgb> cut(const std::filesystem::path& root, const Steps& steps) {
    const Sample sample = sample_in(root, "boxes", panel, steps);
    Camera wide = sample.scene->camera;
    wide.fov_deg = 110;
    const Screen screen(wide, {2 * panel.width, 2 * panel.height});
    Image<Rgb> image = shaded(seen(sample.around, screen, Hidden::depth, steps), sample.around);
    for (Rgb& pixel : image.pixels()) pixel = 0.3f * pixel + 0.7f * white;
    const Image<std::uint32_t> ids = seen(sample.in_view, screen, Hidden::depth, steps);
    const Image<Rgb> inside = shaded(ids, sample.in_view);
    for (std::size_t i = 0; i < ids.size().area(); ++i) {
        if (ids.pixels()[i] != no_node) image.pixels()[i] = inside.pixels()[i];
    }
    const double w = sample.screen().half_width(), h = sample.screen().half_height();
    const std::array<Vec3d, 4> corners{{{-w, -h, 1}, {w, -h, 1}, {w, h, 1}, {-w, h, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        draw(image, *screen.project(corners[i]), *screen.project(corners[(i + 1) % 4]), red);
    }
    return image;
}

/// t4: the painter at work.
Image<Rgb> painting(const std::filesystem::path& root, const Steps& steps) {
    const Sample sample = sample_in(root, "balls", panel, steps);
    const std::vector<Tri> all = sample.sorted();
    std::vector<Image<Rgb>> panels;
    for (const double part : {0.25, 0.6, 1.0}) {
        const std::vector<Tri> some(
            all.begin(), all.begin() + static_cast<std::ptrdiff_t>(part * double(all.size())));
        panels.push_back(shaded(seen(some, sample.screen(), Hidden::painter, steps), some));
    }
    return in_a_row(panels);
}

/// t5: where the corners fall.
Image<Rgb> net(const std::filesystem::path& root, const Steps& steps) {
    std::vector<Image<Rgb>> panels;
    for (const char* name : {"balls", "gems"}) {
        const Sample sample = sample_in(root, name, panel, steps);
        Image<Rgb> image(panel, white);
        for (const ScreenTri& triangle : sample.on_screen) {
            if (triangle.node == no_node) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                draw(image, triangle.px[k], triangle.px[(k + 1) % 3], dark);
            }
        }
        panels.push_back(std::move(image));
    }
    return in_a_row(panels);
}

/// t6: two triangles with a common edge, each pixel many times as large as it is. Dots are centres.
Image<Rgb> rows(const Steps& steps) {
    constexpr int times = 20;
    const Size size{22, 12};
    const std::vector<ScreenTri> triangles{
        {{{{2.5, 1.5}, {18.5, 3.5}, {6.5, 10.5}}}, {0.5, 0.5, 0.5}, 0},
        {{{{18.5, 3.5}, {20, 11}, {6.5, 10.5}}}, {0.5, 0.5, 0.5}, 4}};
    Image<std::uint32_t> ids(size);
    Image<float> depth(size);
    steps.rasterise(triangles, ids.view().tile(), Hidden::painter, ids.view(), depth.view());
    const Image<Rgb> small = coloured(ids);
    Image<Rgb> image({size.width * times, size.height * times});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const bool line = x % times == 0 || y % times == 0;
            const bool dot = std::abs(x % times - times / 2) + std::abs(y % times - times / 2) < 3;
            const Rgb pixel = 0.5f + 0.5f * small(x / times, y / times);
            image(x, y) = dot ? dark : line ? 0.8f * pixel : pixel;
        }
    }
    for (const ScreenTri& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            draw(image, double(times) * triangle.px[k], double(times) * triangle.px[(k + 1) % 3],
                 red);
        }
    }
    return image;
}

/// t6: what comes of it, nodes and depths.
Image<Rgb> buffer(const std::filesystem::path& root, const Steps& steps) {
    const Sample sample = sample_in(root, "balls", panel, steps);
    return in_a_row(
        {coloured(sample.nearest_ids), grading::depth_greys(sample.nearest_depth.view())});
}

/// t7: a buffer that is wrong in squares, what comes of it, and where rays fell back.
Image<Rgb> fallbacks(const std::filesystem::path& root, const Steps& steps) {
    const Sample sample = sample_in(root, "balls", panel, steps);
    const Image<Rgb> hits = coloured(sample.hit_nodes);
    Image<Rgb> marked = hits;
    for (std::size_t i = 0; i < panel.area(); ++i) {
        if (sample.fell_back.pixels()[i] != 0) marked.pixels()[i] = red;
    }
    return in_a_row({coloured(sample.named), hits, marked});
}

}  // namespace

std::vector<grading::NamedPicture> handout_pictures(const std::filesystem::path& root,
                                                    const Steps& steps) {
    return {{"t1", round(steps)},
            {"t2", shapes(root, steps)},
            {"t3", cut(root, steps)},
            {"t4", painting(root, steps)},
            {"t5", net(root, steps)},
            {"t6", rows(steps)},
            {"t6_ids", buffer(root, steps)},
            {"t7", fallbacks(root, steps)}};
}

}  // namespace luch::homework::vista
