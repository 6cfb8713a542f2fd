#include "engine/model/block/symbol_check.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stepwire {

namespace {

[[noreturn]] void refuse(const BlockType& type, const std::string& why) {
  throw std::logic_error("the symbol of " + type.name + " " + why);
}

/// Checks a placeholder without its braces: `name`, `name|else` or `name:s`.
void check_place(const BlockType& type, std::string_view place) {
  const std::string name(place.substr(0, std::min(place.find('|'), place.find(':'))));
  const ParameterSpec* spec = type.parameter(name);
  if (!spec)
    refuse(type, "has the place {" + std::string(place) + "}, but it has no parameter '" + name + "'");
  if (place.find(':') < place.find('|') && spec->kind != ParameterKind::vector)
    refuse(type, "shows '" + name + "' as a polynomial, but it is no list of coefficients");
}

}  // namespace

void check_symbol(const BlockType& type) {
  const std::string_view text = type.symbol.text;
  for (std::size_t at = 0; (at = text.find_first_of("{}", at)) != text.npos; ++at) {
    const std::size_t end = text.find('}', at);
    if (text[at] == '}' || end == text.npos) refuse(type, "has a brace without its other half");
    check_place(type, text.substr(at + 1, end - at - 1));
    at = end;
  }
  if (!type.symbol.signs.empty() && !type.parameter(type.symbol.signs))
    refuse(type, "takes its signs from '" + type.symbol.signs + "', but that is no parameter");
}

}  // namespace stepwire
