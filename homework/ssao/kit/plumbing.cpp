// The students' kit: the technique without its reference steps. Where a step is not written there
// is none: stand_ins.h says what is known instead, and a picture that takes more than that is
// hatched.
#include "framework/technique/context.h"
#include "homework/ssao/stand_ins.h"
#include "techniques/ssao/render.h"

#include <algorithm>
#include <array>

namespace luch::techniques::ssao {
namespace {

constexpr std::array<double, 6> sample_counts{4, 8, 18, 36, 72, 144};

/// Stripes over a picture that is not what it will be.
void hatch(ImageView<Rgb> colour) {
    constexpr int stripe = 4;
    for (int y = 0; y < colour.height(); ++y) {
        for (int x = 0; x < colour.width(); ++x) {
            if ((x + y) / stripe % 2 != 0) colour(x, y) *= 0.4f;
        }
    }
}

class Hatched final : public Technique {
 public:
    explicit Hatched(std::unique_ptr<Technique> technique) : technique_(std::move(technique)) {}

    void visit(ParamVisitor& visitor) override { technique_->visit(visitor); }
    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return technique_->plan(scene, shot);
    }
    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        technique_->prepare(scene, shot, context);
    }
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        technique_->render(scene, shot, frame, context);
        const auto depth = std::ranges::find(frame.planes(), "depth", &Plane2d::name);
        const bool known =
            depth != frame.planes().end() && is_public(std::get<Image<float>>(depth->pixels));
        for (const std::string& task : context.unwritten()) {
            const bool stored = task == "ssao.t1" || task == "ssao.t2";
            if (!known || !stored) return hatch(frame.colour.view());
        }
    }

 private:
    std::unique_ptr<Technique> technique_;
};

}  // namespace

std::unique_ptr<Technique> make(const Steps& steps, const Params& params) {
    return std::make_unique<Hatched>(technique_of(steps, params));
}

const std::span<const double> samples_to_walk{sample_counts};

}  // namespace luch::techniques::ssao
