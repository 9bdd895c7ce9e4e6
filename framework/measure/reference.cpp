#include "framework/measure/reference.h"

#include "framework/base/error.h"
#include "framework/measure/digest.h"
#include "framework/measure/metrics.h"

#include <fmt/format.h>

namespace luch {
namespace {

/// Of what is in a file; another number, and no file made before is used.
constexpr int format_version = 1;

/// The passes' seeds begin here, far from those of truths and frames.
constexpr std::uint64_t first_pass = 1000;

std::string_view bytes_in(const Image<Rgb>& image) {
    return {reinterpret_cast<const char*>(image.pixels().data()),
            image.pixels().size() * sizeof(Rgb)};
}

Subject with_samples(const Subject& subject, int spp) {
    Subject other = subject;
    other.spp = spp;
    return other;
}

}  // namespace

std::string ReferenceCache::key_of(const Subject& subject, const Workbench& bench,
                                   std::uint64_t seed) const {
    const Image<Rgb> first = picture_of(with_samples(subject, 2), bench, seed);
    Digest digest;
    digest.part(fmt::format("luch reference {}", format_version))
        .part(content_)
        .part(fmt::format("{}x{}", bench.shot.size.width, bench.shot.size.height))
        .part(fmt::format("frame {} time {}", bench.shot.frame, bench.shot.time_s))
        .part(subject.info->name)
        .part(subject.assignment)
        .part(fmt::format("spp {} seed {} skip {}", subject.spp, seed, subject.skip))
        .part(bytes_in(first));
    return digest.text();
}

Image<Rgb> ReferenceCache::picture(const Subject& subject, const Workbench& bench,
                                   std::uint64_t seed, bool& from_cache) const {
    const bool kept = store_ && !content_.empty();
    const std::string key = kept ? key_of(subject, bench, seed) : "";
    if (kept) {
        const std::optional<std::string> bytes = store_->get(key);
        std::optional<Image<Rgb>> image = bytes ? image_of(*bytes) : std::nullopt;
        if (image && image->size() == bench.shot.size) return std::move(*image);
    }
    from_cache = false;
    Image<Rgb> image = picture_of(subject, bench, seed);
    if (kept) store_->put(key, bytes_of(image));
    return image;
}

Reference ReferenceCache::reference(const Subject& subject, const Workbench& bench,
                                    int samples) const {
    const Subject half = with_samples(subject, std::max(1, samples / 2));
    bool from_cache = true;
    const Image<Rgb> a = picture(half, bench, bench.shot.seed + 1, from_cache);
    const Image<Rgb> b = picture(half, bench, bench.shot.seed + 2, from_cache);
    Reference reference = reference_of_halves(a, b);
    reference.samples = 2 * half.spp;
    reference.from_cache = from_cache;
    return reference;
}

double rmse_between(const Image<Rgb>& a, const Image<Rgb>& b) {
    if (a.size() != b.size()) throw Error("the pictures differ in size: compare two of one size");
    double squared = 0, channels = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        if (!all_finite(a.pixels()[i]) || !all_finite(b.pixels()[i])) continue;
        const Vec3d off = Vec3d(b.pixels()[i]) - Vec3d(a.pixels()[i]);
        squared += glm::dot(off, off);
        channels += 3;
    }
    return channels > 0 ? std::sqrt(squared / channels) : 0;
}

Reference reference_of_halves(const Image<Rgb>& a, const Image<Rgb>& b) {
    Reference reference;
    reference.linear_error = rmse_between(a, b) / 2;
    reference.displayed_error = rmse_between(displayed(a.view()), displayed(b.view())) / 2;
    reference.linear = a;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        reference.linear.pixels()[i] = 0.5f * (a.pixels()[i] + b.pixels()[i]);
    }
    return reference;
}

LabPasses independent_passes(const Subject& subject, const Workbench& bench,
                             const Image<Rgb>& truth, int most) {
    const Subject once = with_samples(subject, 2);
    LabPasses passes;
    std::vector<Vec3d> sum(truth.pixels().size(), Vec3d(0));
    Image<Rgb> mean(truth.size());
    for (int n = 1; n <= most; ++n) {
        const auto seed = bench.shot.seed + first_pass + static_cast<std::uint64_t>(n);
        const Image<Rgb> frame = picture_of(once, bench, seed);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += Vec3d(frame.pixels()[i]);
            mean.pixels()[i] = Rgb(sum[i] / static_cast<double>(n));
        }
        if ((n & (n - 1)) != 0) continue;
        passes.count.push_back(n);
        passes.linear_rmse.push_back(rmse_between(truth, mean));
    }
    return passes;
}

}  // namespace luch
