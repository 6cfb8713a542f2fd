#include "engine/base/fmi/unit_table.hpp"

#include <fmt/format.h>

#include "engine/base/unit/unit.hpp"

namespace stepwire::fmi {

ScaledUnit base_unit(const BaseExponents& exponents, double factor, double offset) {
  std::string product;
  for (const auto& [base, exponent] : exponents)
    if (exponent != 0) product += fmt::format("{}{}^{}", product.empty() ? "" : " ", base, exponent);
  const auto unit = unit::parse_unit(product);
  return {unit ? unit::si_name(unit->dimension) : "*", factor, offset};
}

ScaledUnit named_unit(const std::string& name) {
  const auto unit = unit::parse_unit(name);
  if (!unit) return {};
  return {unit::si_name(unit->dimension), static_cast<double>(unit->scale), static_cast<double>(unit->offset)};
}

}  // namespace stepwire::fmi
