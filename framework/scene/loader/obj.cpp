#include "framework/scene/loader/obj.h"

#include "framework/base/files.h"
#include "framework/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace luch::loader {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

/// Cuts the first word off a line; empty when there is none left.
std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

/// Statements that change no polygon: groups, materials, points, lines, and curves.
bool is_passed_over(std::string_view word) {
    constexpr std::string_view words[] = {
        "g",      "o",          "s",         "mg",    "usemtl", "mtllib",   "usemap",
        "maplib", "p",          "l",         "vp",    "bmat",   "step",     "cstype",
        "deg",    "curv",       "curv2",     "surf",  "parm",   "trim",     "hole",
        "scrv",   "sp",         "end",       "con",   "bevel",  "c_interp", "d_interp",
        "lod",    "shadow_obj", "trace_obj", "ctech", "stech"};
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

class Reader {
 public:
    Reader(std::string file, Diagnostics& diagnostics)
        : file_(std::move(file)), diagnostics_(diagnostics) {}

    void take(std::string_view line) {
        ++line_;
        line = line.substr(0, line.find('#'));
        const std::string_view word = next_word(line);
        if (word == "v") {
            obj_.positions.push_back(vector(line, 3));
        } else if (word == "vn") {
            obj_.normals.push_back(vector(line, 3));
        } else if (word == "vt") {
            obj_.uvs.emplace_back(vector(line, 1));
        } else if (word == "f") {
            take_face(line);
        } else if (!word.empty() && !is_passed_over(word)) {
            take_unknown(word);
        }
    }

    RawMesh finish() {
        if (obj_.positions.empty()) {
            throw Error({file_}, "holds no vertices; name a mesh in OBJ format");
        }
        for (std::size_t i = 0; i < obj_.triangles.size(); ++i) {
            line_ = lines_[i];
            for (const RawCorner& corner : obj_.triangles[i]) check(corner);
        }
        if (obj_.triangles.empty()) {
            diagnostics_.warn({file_}, "holds no faces; nothing of it will be drawn");
        }
        return std::move(obj_);
    }

 private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Error({file_, line_}, message);
    }

    /// Three numbers, of which `needed` must be there; further ones (weights, colours) are left.
    Vec3d vector(std::string_view line, int needed) const {
        constexpr double most = 1e30;
        Vec3d result{0};
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = next_word(line);
            if (word.empty() && k >= needed) break;
            const auto value = parsed_number(word);
            if (!value || std::abs(*value) > most) {
                fail(fmt::format("{} is not a number from -1e30 to 1e30; correct the mesh",
                                 shown(word)));
            }
            result[k] = *value;
        }
        return result;
    }

    /// One of the up to three numbers in "7/1/-2"; `count` is how many there are to count back
    /// from.
    std::int64_t index(std::string_view word, std::string_view part, std::size_t count) const {
        std::int64_t value = 0;
        const char* const end = part.data() + part.size();
        const auto [stop, problem] = std::from_chars(part.data(), end, value);
        if (problem != std::errc{} || stop != end || value == 0) {
            fail(
                fmt::format("the corner {} is not of the form 1, 1/2, 1//3 or 1/2/3; correct the "
                            "mesh",
                            shown(word)));
        }
        const std::int64_t from_zero =
            value > 0 ? value - 1 : static_cast<std::int64_t>(count) + value;
        if (from_zero < 0) fail_index(value, count);
        return from_zero;
    }

    [[noreturn]] void fail_index(std::int64_t value, std::size_t count) const {
        fail(fmt::format("the face refers to number {} of {}; correct the mesh", value, count));
    }

    RawCorner corner(std::string_view word) const {
        RawCorner result;
        std::string_view rest = word;
        const auto part = [&] {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::string_view text = rest.substr(0, slash);
            rest.remove_prefix(std::min(slash + 1, rest.size()));
            return text;
        };
        result.position = index(word, part(), obj_.positions.size());
        if (const auto text = part(); !text.empty()) {
            result.uv = index(word, text, obj_.uvs.size());
        }
        if (!rest.empty()) result.normal = index(word, rest, obj_.normals.size());
        return result;
    }

    /// A polygon is a fan of triangles from its first corner.
    void take_face(std::string_view line) {
        constexpr std::size_t most = (std::size_t{1} << 31) - 1;
        RawCorner first, previous;
        int count = 0;
        for (std::string_view word; !(word = next_word(line)).empty(); ++count) {
            const RawCorner current = corner(word);
            if (count == 0) first = current;
            if (count >= 2) {
                if (obj_.triangles.size() >= most) fail("is one triangle too many; split the mesh");
                obj_.triangles.push_back({first, previous, current});
                lines_.push_back(line_);
            }
            previous = current;
        }
        if (count < 3) fail("the face has fewer than three corners; correct the mesh");
    }

    void take_unknown(std::string_view word) {
        if (word.find('\0') != std::string_view::npos) {
            fail("holds a zero byte; name a mesh in OBJ format");
        }
        if (!std::exchange(warned_, true)) {
            diagnostics_.warn({file_, line_}, fmt::format("{} is no statement of OBJ; lines like "
                                                          "this are passed over",
                                                          shown(word)));
        }
    }

    /// Positive indices may lead to later lines, so they are checked when all are read.
    void check(const RawCorner& corner) const {
        const auto is_in = [&](std::int64_t index, std::size_t count) {
            if (index >= static_cast<std::int64_t>(count)) fail_index(index + 1, count);
        };
        is_in(corner.position, obj_.positions.size());
        is_in(corner.uv, obj_.uvs.size());
        is_in(corner.normal, obj_.normals.size());
    }

    std::string file_;
    Diagnostics& diagnostics_;
    RawMesh obj_;
    std::vector<int> lines_;  ///< of the triangles
    int line_ = 0;
    bool warned_ = false;
};

}  // namespace

RawMesh read_obj(const std::filesystem::path& file, Diagnostics& diagnostics) {
    const std::string bytes = read_text(file);
    Reader reader(file.string(), diagnostics);
    for (std::string_view text = bytes; !text.empty();) {
        const std::size_t end = text.find('\n');
        reader.take(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return reader.finish();
}

}  // namespace luch::loader
