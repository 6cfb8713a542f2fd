#include "engine/base/table/csv_title.hpp"

namespace stepwire::table {

std::string csv_trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Column csv_column(const std::string& title) {
  const std::size_t open = title.rfind('[');
  if (title.empty() || title.back() != ']' || open == std::string::npos || open == 0) return {title, "", {}};
  const std::string unit = title.substr(open + 1, title.size() - open - 2);
  const bool digits = !unit.empty() && unit.find_first_not_of("0123456789") == std::string::npos;
  if (digits && !is_csv_blank(title[open - 1])) return {title, "", {}};
  return {csv_trimmed(title.substr(0, open)), csv_trimmed(unit), {}};
}

}  // namespace stepwire::table
