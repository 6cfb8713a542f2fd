#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// A table for readers. Columns of numbers are set to the right, others to the left.
struct TextTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
  std::vector<std::string> notes;              ///< below it, one paragraph each
};

/// The table in letters of one width, its notes wrapped below it.
std::string text(const TextTable& table);

/// The table as SVG.
std::string draw(const TextTable& table);

}  // namespace stepwire
