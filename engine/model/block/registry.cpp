#include "engine/model/block/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/model/block/block_type.hpp"

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

/// Checks that the placeholders and signs of a symbol name parameters of its kind, so that every declared
/// block can be drawn. Throws std::logic_error that names the kind and the placeholder.
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

}  // namespace

void Registry::add(BlockType type) {
  check_symbol(type);
  if (const BlockType* known = find(type.name))
    throw std::logic_error(fmt::format("{}: a block is called {} already, that of {}", type.declared_at,
                                       type.name, known->declared_at));
  const std::string name = type.name;
  types_.emplace(name, std::make_unique<const BlockType>(std::move(type)));
}

const BlockType* Registry::find(std::string_view name) const {
  const auto found = types_.find(name);
  return found == types_.end() ? nullptr : found->second.get();
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> result;
  for (const auto& [name, type] : types_) result.push_back(name);
  return result;
}

std::vector<const BlockType*> Registry::types() const {
  std::vector<const BlockType*> result;
  for (const auto& [name, type] : types_) result.push_back(type.get());
  return result;
}

}  // namespace stepwire
