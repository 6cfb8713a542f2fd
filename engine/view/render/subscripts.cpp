#include "engine/view/render/subscripts.hpp"

#include <cctype>
#include <cstddef>

namespace stepwire::render {
namespace {

/// Begin of the text after an index. Without the second attribute librsvg drops a leading blank.
constexpr const char* back = "<tspan dy=\"-3\" xml:space=\"preserve\">";

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

/// Returns the length of the index after the underscore at `at`; 0 if it is not in a quantity.
std::size_t index_length(const std::string& label, std::size_t at) {
  std::size_t start = at;
  while (start > 0 && is_word(label[start - 1])) --start;
  const std::size_t letters = at - start;
  if (letters < 1 || letters > 2 || !is_capital(label[start]) || !is_capital(label[at - 1])) return 0;
  std::size_t end = at + 1;
  while (end < label.size() && is_word(label[end])) ++end;
  const std::size_t length = end - at - 1;
  return length >= 1 && length <= 3 && label.find_first_of("_.", at + 1) >= end ? length : 0;
}

}  // namespace

std::string with_subscripts(const std::string& label) {
  for (std::size_t at = label.find('_'); at != std::string::npos; at = label.find('_', at + 1)) {
    const std::size_t length = index_length(label, at);
    if (length == 0) continue;
    const std::string rest = label.substr(at + 1 + length);
    return label.substr(0, at) + "<tspan dy=\"3\" font-size=\"0.75em\">" + label.substr(at + 1, length) +
           "</tspan>" + (rest.empty() ? "" : back + with_subscripts(rest) + "</tspan>");
  }
  return label;
}

void set_subscripts(std::string& svg) {
  const std::string begin = "<text>", end = "</text>";
  for (std::size_t at = 0; (at = svg.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    const std::size_t length = svg.find(end, at) - at;
    const std::string label = svg.substr(at, length), set = with_subscripts(label);
    if (set != label) svg.replace(at, length, set);
    at += set.size();
  }
}

}  // namespace stepwire::render
