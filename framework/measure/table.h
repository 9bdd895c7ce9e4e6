#pragma once

#include <string>
#include <vector>

namespace luch {

/// A table for a terminal: the first column is flush left, the others flush right. A short row's
/// last cell runs on to the right and widens no column.
class TextTable {
 public:
    explicit TextTable(std::vector<std::string> header) : header_(std::move(header)) {}

    /// At most as many cells as the header has.
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::string text() const;

 private:
    std::vector<std::string> header_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace luch
