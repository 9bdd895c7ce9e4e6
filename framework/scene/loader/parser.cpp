#include "framework/scene/loader/parser.h"

#include "framework/base/text.h"
#include "framework/scene/loader/random_values.h"

#include <fmt/format.h>

namespace luch::loader {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// The line up to `#` or `//`; both may stand within quotes.
std::string_view without_comment(std::string_view line) {
    bool in_quotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') in_quotes = !in_quotes;
        if (!in_quotes && (line[i] == '#' || line.substr(i, 2) == "//")) return line.substr(0, i);
    }
    return line;
}

bool has_bare_brace(std::string_view value) {
    bool in_quotes = false;
    for (const char c : value) {
        if (c == '"') in_quotes = !in_quotes;
        if (!in_quotes && (c == '{' || c == '}')) return true;
    }
    return false;
}

class Parser {
 public:
    explicit Parser(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void take(std::string_view line) {
        constexpr std::size_t longest = 1 << 16;
        ++line_;
        if (line.size() > longest) fail("the line is longer than 65,536 characters; split it");
        if (line.find('\0') != std::string_view::npos) {
            fail("holds a zero byte; a scene is a text file");
        }
        if (skipped_as_comment(line)) return;
        const std::string_view text = trimmed(without_comment(line));
        if (text.empty()) return;
        if (in_block_) {
            take_inside(text);
        } else {
            take_outside(text);
        }
    }

    std::vector<Block> finish() {
        if (comment_line_ > 0) {
            diagnostics_.fail(comment_line_,
                              "the comment is never closed; end it with a line that "
                              "begins with */");
        }
        if (in_block_) {
            const Block& block = blocks_.back();
            diagnostics_.fail(block.line, fmt::format("the block {} is never closed; end it with }} "
                                                      "on a line of its own",
                                                      title(block)));
        }
        return std::move(blocks_);
    }

 private:
    [[noreturn]] void fail(const std::string& message) const { diagnostics_.fail(line_, message); }

    static std::string title(const Block& block) {
        return shown(block.name.empty() ? block.class_name : block.class_name + " " + block.name);
    }

    /// A block comment runs from a line that begins with /* to a line with */ in its first column.
    bool skipped_as_comment(std::string_view line) {
        const bool opens = comment_line_ == 0 && trimmed(line).starts_with("/*");
        if (comment_line_ > 0 && line.starts_with("*/")) {
            comment_line_ = 0;
            return true;
        }
        if (opens) comment_line_ = line_;
        if (comment_line_ == 0) return false;
        if (line.find("*/", opens ? line.find("/*") + 2 : 0) != std::string_view::npos) {
            diagnostics_.warn(line_,
                              "this */ does not close the comment; put it at the very "
                              "beginning of a line");
        }
        return true;
    }

    void take_outside(std::string_view text) {
        if (text == "}") fail("this } closes nothing; remove it");
        const std::vector<std::string> words = words_of(text.substr(0, text.size() - 1));
        if (!text.ends_with('{') || words.empty() || words.size() > 2) {
            fail(shown(text) + " does not open a block; write \"Class name {\"");
        }
        blocks_.push_back({words[0], words.size() > 1 ? words[1] : "", line_, {}});
        in_block_ = true;
    }

    void take_inside(std::string_view text) {
        if (text == "}") {
            in_block_ = false;
            return;
        }
        if (text.ends_with('{')) {
            fail(
                fmt::format("a block opens inside the block {} of line {}; close that one first, "
                            "with }} on a line of its own",
                            title(blocks_.back()), blocks_.back().line));
        }
        std::size_t length = 0;
        while (length < text.size() && is_letter(text[length])) ++length;
        const std::string_view value = trimmed(text.substr(length));
        if (length == 0 || has_bare_brace(value)) {
            fail(shown(text) +
                 " is not a property; write \"name value\", one to a line, and } "
                 "on a line of its own");
        }
        blocks_.back().properties.push_back({std::string(text.substr(0, length)),
                                             with_random_values(value, line_, diagnostics_),
                                             line_});
    }

    Diagnostics& diagnostics_;
    std::vector<Block> blocks_;
    int line_ = 0;
    int comment_line_ = 0;  ///< where the comment that we are in began; 0: in none
    bool in_block_ = false;
};

}  // namespace

std::vector<Block> parse_blocks(std::string_view text, Diagnostics& diagnostics) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    Parser parser(diagnostics);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        parser.take(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return parser.finish();
}

std::vector<std::string> words_of(std::string_view value) {
    constexpr std::string_view separators = " \t\r\v\f(),";
    std::vector<std::string> words;
    for (;;) {
        const std::size_t start = value.find_first_not_of(separators);
        if (start == std::string_view::npos) return words;
        value.remove_prefix(start);
        const bool in_quotes = value.front() == '"';
        if (in_quotes) value.remove_prefix(1);
        const std::size_t end = in_quotes ? value.find('"') : value.find_first_of(separators);
        words.emplace_back(value.substr(0, end));
        if (end == std::string_view::npos) return words;
        value.remove_prefix(end + 1);
    }
}

}  // namespace luch::loader
