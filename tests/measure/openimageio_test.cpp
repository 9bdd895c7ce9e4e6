#include "framework/image/io.h"
#include "framework/math/rng.h"
#include "framework/measure/difference.h"
#include "framework/measure/metrics.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace luch {
namespace {

/// The number after a word in idiff's report: "  RMS error = 0.123".
double number_after(const std::string& text, const std::string& word) {
    const std::size_t at = text.find(word + " = ");
    return at == std::string::npos ? -1 : std::strtod(text.c_str() + at + word.size() + 3, nullptr);
}

Image<Rgb> noise(std::uint64_t seed) {
    Image<Rgb> image({64, 48});
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Key key = Key(seed).branch(i);
        image.pixels()[i] = Rgb(key.uniform(0), key.uniform(1), key.uniform(2));
    }
    return image;
}

/// Writes two pictures, compares them here and by OpenImageIO's idiff.
void expect_agreement(const std::string& ending, double tolerance) {
    if (shell("idiff --help").status != 0) GTEST_SKIP() << "idiff is not installed";
    const auto folder = own_folder();
    const auto a = folder / ("a" + ending), b = folder / ("b" + ending);
    write_displayed(a, noise(1).view());
    write_displayed(b, noise(2).view());
    const Image<Rgb> first = read_picture(a).pixels, second = read_picture(b).pixels;
    const Errors errors = errors_between(first.view(), second.view());
    const std::string theirs = shell("idiff '" + a.string() + "' '" + b.string() + "'").text;
    const double rmse = number_after(theirs, "RMS error");
    const double psnr = number_after(theirs, "Peak SNR");
    EXPECT_NEAR(errors.rmse / rmse, 1, tolerance) << theirs;
    EXPECT_NEAR(errors.psnr / psnr, 1, tolerance) << theirs;
    std::filesystem::remove_all(folder);
}

TEST(OpenImageIo, AgreesOnRmseAndPsnrOfEightBitPictures) {
    expect_agreement(".png", 1e-6);
}

TEST(OpenImageIo, AgreesOnRmseAndPsnrOfLinearPictures) {
    expect_agreement(".exr", 1e-6);
}

}  // namespace
}  // namespace luch
