#include "engine/app/fmu/parameter_limits.hpp"

#include "engine/base/unit/unit.hpp"

namespace stepwire::fmu {

std::string written_unit(const std::string& text) {
  const std::size_t at = text.find_first_not_of("+-.0123456789eE \t");
  if (at == std::string::npos || !unit::parse_quantity(text)) return "";
  const std::string name = text.substr(at);
  const auto unit = unit::parse_unit(name);
  const bool is_other = unit && (unit->scale != 1.0L || unit->offset != 0.0L);
  return is_other ? name : "";
}

void limit(std::optional<double>& at_least, std::optional<double>& at_most,
           const std::vector<yaml::Entry>& bounds) {
  for (const yaml::Entry& bound : bounds) {
    const auto quantity = unit::parse_quantity(bound.value.text);
    if (!quantity) continue;
    (bound.key == "above" || bound.key == "at_least" ? at_least : at_most) = quantity->value;
  }
}

}  // namespace stepwire::fmu
