#include "tests/random/value_tools.hpp"

#include <fmt/format.h>

namespace stepwire::random {

std::vector<double> some(Making& making, Index count) {
  std::vector<double> numbers;
  for (Index k = 0; k < count; ++k) numbers.push_back(making.bench.signed_size());
  return numbers;
}

std::string list(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + digits(number);
  return "[" + text + "]";
}

std::string in_unit(Making& making, const std::string& numbers, const char* unit_variable) {
  const unit::Dimension unit = making.unit_of(unit_variable);
  return unit == unit::Dimension{} ? numbers
                                   : fmt::format("{{value: {}, unit: {}}}", numbers, unit::si_name(unit));
}

/// Coefficients of a polynomial with these roots, highest power first.

double slowest(Making& making) {
  return 4.0 / (making.bench.step * making.bench.ticks);
}

std::string without(Making&) {
  return "";
}

}  // namespace stepwire::random
