#include "engine/model/diagram/element_index.hpp"

#include <fmt/format.h>

namespace stepwire::diagram {

namespace {

/// Removes the number at the end of a dotted name and returns it; 0 without one.
Eigen::Index take_number(std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string digits = dot == std::string::npos ? "" : name.substr(dot + 1);
  const bool is_number = !digits.empty() && digits.size() < 10 && digits[0] != '0' &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number) return 0;
  name.resize(dot);
  return std::stol(digits);
}

}  // namespace

ElementIndex take_element(std::string& name) {
  const Eigen::Index last = take_number(name);
  const Eigen::Index before = last > 0 ? take_number(name) : 0;
  return before > 0 ? ElementIndex{before, last} : ElementIndex{last, 0};
}

std::string element_text(const ElementIndex& element) {
  if (element.is_whole()) return "";
  return element.column == 0 ? fmt::format(".{}", element.row)
                             : fmt::format(".{}.{}", element.row, element.column);
}

}  // namespace stepwire::diagram
