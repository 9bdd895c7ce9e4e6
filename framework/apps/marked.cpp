#include "framework/apps/marked.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <cmath>
#include <utility>

namespace luch {
namespace {

class Marked final : public Technique {
 public:
    Marked(std::unique_ptr<Technique> technique, const MarkedPixel& pixel)
        : technique_(std::move(technique)), pixel_(pixel) {}

    void visit(ParamVisitor& visitor) override { technique_->visit(visitor); }
    [[nodiscard]] Plan plan(const Scene& scene, const Shot& shot) const override {
        return technique_->plan(scene, shot);
    }
    void prepare(const Scene& scene, const Shot& shot, Context& context) override {
        technique_->prepare(scene, shot, context);
    }
    void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) override {
        frame.marks.clear();
        technique_->render(scene, shot, frame, context);
        const float across = static_cast<float>(frame.size().width) / pixel_.of.width;
        const float down = static_cast<float>(frame.size().height) / pixel_.of.height;
        // Two colours: one of them can be told from whatever is there.
        for (const auto& [around, colour] : {std::pair(0, Rgb(1, 0, 1)), {1, Rgb(1, 1, 0)}}) {
            const Mark mark{Mark::rectangle,
                            static_cast<float>(pixel_.x) * across - around,
                            static_cast<float>(pixel_.y) * down - around,
                            static_cast<float>(pixel_.x + 1) * across + around,
                            static_cast<float>(pixel_.y + 1) * down + around,
                            colour};
            frame.marks.push_back(mark);
        }
    }

 private:
    std::unique_ptr<Technique> technique_;
    MarkedPixel pixel_;
};

}  // namespace

MarkedPixel parsed_pixel(const std::string& text, Size of) {
    const std::vector<std::string> words = split(text, ',');
    if (words.size() == 2) {
        const auto x = parsed_number(words[0]), y = parsed_number(words[1]);
        if (x && y && *x >= 0 && *y >= 0 && *x < of.width && *y < of.height &&
            *x == std::floor(*x) && *y == std::floor(*y)) {
            return {static_cast<int>(*x), static_cast<int>(*y), of};
        }
    }
    throw Error("--pixel " + text + ": give X,Y with whole numbers below " +
                std::to_string(of.width) + "," + std::to_string(of.height) +
                ", the size of the frame");
}

std::unique_ptr<Technique> marked(std::unique_ptr<Technique> technique, const MarkedPixel& pixel) {
    return std::make_unique<Marked>(std::move(technique), pixel);
}

}  // namespace luch
