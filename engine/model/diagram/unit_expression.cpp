#include "engine/model/diagram/unit_expression.hpp"

#include <cstdlib>

namespace stepwire::diagram {

namespace {

struct Factor {
  std::string text;
  double sign;
};

std::vector<Factor> split(std::string_view text) {
  std::vector<Factor> factors;
  double sign = 1.0;
  std::string token;
  const auto finish = [&] {
    if (!token.empty()) factors.push_back({token, sign});
    if (!token.empty()) sign = 1.0;
    token.clear();
  };
  for (char c : text) {
    if (c != ' ' && c != '*' && c != '/') {
      token += c;
      continue;
    }
    finish();
    if (c == '/') sign = -1.0;
  }
  finish();
  return factors;
}

}  // namespace

std::optional<UnitExpression> parse_unit_expression(std::string_view text) {
  UnitExpression result;
  if (text == "*") {
    result.any = true;
    return result;
  }
  constexpr std::string_view difference = "delta ";
  result.is_difference = text.starts_with(difference);
  if (result.is_difference) text.remove_prefix(difference.size());
  for (const Factor& factor : split(text.substr(0, text.find(" by ")))) {
    if (factor.text.front() != '\'') {
      const auto unit = unit::parse_unit(factor.text);
      if (!unit) return std::nullopt;
      result.constant = result.constant * unit::power(unit->dimension, factor.sign);
      continue;
    }
    const std::size_t caret = factor.text.find('^');
    const double exponent = caret == std::string::npos ? 1.0 : std::atof(factor.text.c_str() + caret + 1);
    result.variables.emplace_back(factor.text.substr(1, caret - 1), factor.sign * exponent);
  }
  return result;
}

}  // namespace stepwire::diagram
