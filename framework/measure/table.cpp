#include "framework/measure/table.h"

#include <algorithm>

namespace luch {
namespace {

/// Characters, not bytes: continuation bytes of UTF-8 take no room.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::string blanks(width > width_of(text) ? width - width_of(text) : 0, ' ');
    return left ? text + blanks : blanks + text;
}

}  // namespace

std::string TextTable::text() const {
    std::vector<std::size_t> widths;
    for (const std::string& title : header_) widths.push_back(width_of(title));
    for (const auto& row : rows_) {
        const std::size_t aligned = row.size() == header_.size() ? row.size() : row.size() - 1;
        for (std::size_t i = 0; i < aligned; ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    std::string text;
    const auto put = [&](const std::vector<std::string>& row) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (i > 0) line += "  ";
            const bool runs_on = i + 1 == row.size() && row.size() < header_.size();
            line += runs_on ? row[i] : padded(row[i], widths[i], i == 0);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    };
    put(header_);
    for (const auto& row : rows_) put(row);
    return text;
}

}  // namespace luch
