#pragma once

#include "framework/math/size.h"

#include <cassert>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace luch {

/// A view of a whole image: row-major, (0,0) is the top-left pixel. It owns nothing and never
/// dangles past the call it was made for. ImageView<const T> only reads.
template <class T>
class ImageView {
 public:
    ImageView() = default;
    ImageView(T* pixels, Size size) : pixels_(pixels), size_(size) {}
    template <class U, class = std::enable_if_t<std::is_same_v<const U, T>>>
    ImageView(ImageView<U> other) : pixels_(other.data()), size_(other.size()) {}  // NOLINT

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] int width() const { return size_.width; }
    [[nodiscard]] int height() const { return size_.height; }
    [[nodiscard]] Tile tile() const { return {0, 0, size_.width, size_.height}; }
    [[nodiscard]] T* data() const { return pixels_; }
    [[nodiscard]] T& operator()(int x, int y) const {
        assert(x >= 0 && y >= 0 && x < size_.width && y < size_.height);
        return pixels_[static_cast<std::size_t>(y) * size_.width + x];
    }

 private:
    T* pixels_ = nullptr;
    Size size_;
};

/// An image that owns its pixels.
template <class T>
class Image {
 public:
    Image() = default;
    explicit Image(Size size, const T& value = T()) : pixels_(size.area(), value), size_(size) {}

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] int width() const { return size_.width; }
    [[nodiscard]] int height() const { return size_.height; }
    [[nodiscard]] T& operator()(int x, int y) { return view()(x, y); }
    [[nodiscard]] const T& operator()(int x, int y) const { return view()(x, y); }
    [[nodiscard]] ImageView<T> view() { return {pixels_.data(), size_}; }
    [[nodiscard]] ImageView<const T> view() const { return {pixels_.data(), size_}; }
    [[nodiscard]] std::vector<T>& pixels() { return pixels_; }
    [[nodiscard]] const std::vector<T>& pixels() const { return pixels_; }
    bool operator==(const Image&) const = default;

 private:
    std::vector<T> pixels_;
    Size size_;
};

}  // namespace luch
