#include "framework/technique/frame.h"

namespace luch {

void Frame::resize(Size size) {
    if (size == this->size()) return;
    colour = Image<Rgb>(size);
    planes_.clear();
    marks.clear();
}

}  // namespace luch
