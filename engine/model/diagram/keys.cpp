#include "engine/model/diagram/keys.hpp"

#include <algorithm>
#include <cctype>

namespace stepwire::diagram {

bool is_name(const std::string& text) {
  const auto letter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
  return !text.empty() && letter(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) { return letter(c) || std::isdigit(c); });
}

bool is_dotted_name(const std::string& text) {
  for (std::size_t first = 0;;) {
    const std::size_t dot = text.find('.', first);
    if (!is_name(text.substr(first, dot - first))) return false;
    if (dot == std::string::npos) return true;
    first = dot + 1;
  }
}

}  // namespace stepwire::diagram
