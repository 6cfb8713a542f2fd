#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

namespace {

/// Returns the shortest matching prefix of a dotted text: of "a.b.c" it tries "a", "a.b" and "a.b.c".
template <class Fits>
std::string_view first_start(std::string_view text, const Fits& fits) {
  for (std::size_t dot = text.find('.');; dot = text.find('.', dot + 1)) {
    const std::string_view start = text.substr(0, dot);
    if (fits(start)) return start;
    if (dot == std::string_view::npos) return {};
  }
}

}  // namespace

std::vector<std::string> Scope::block_names() const {
  std::vector<std::string> result;
  for (const auto& [name, named] : names) result.push_back(name);
  for (const auto& [name, port] : inputs) result.push_back(name);
  return result;
}

std::string_view Scope::start_of(std::string_view reference) const {
  return first_start(
      reference, [this](std::string_view start) { return names.contains(start) || failed.contains(start); });
}

std::string_view Scope::input_of(std::string_view reference) const {
  return first_start(reference, [this](std::string_view start) { return inputs.contains(start); });
}

std::string Scope::rival_of(const std::string& name) const {
  const std::string_view start = first_start(name, [&](std::string_view start) {
    return start != name && (names.contains(start) || inputs.contains(start));
  });
  if (!start.empty()) return std::string(start);
  const auto longer = names.lower_bound(name + ".");
  return longer != names.end() && longer->first.starts_with(name + ".") ? longer->first : "";
}

}  // namespace stepwire::diagram
