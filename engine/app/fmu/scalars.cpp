#include "engine/app/fmu/scalars.hpp"

#include <fmt/format.h>

namespace stepwire::fmu {

namespace {

/// Returns the index of the k-th number in row-major order: "[2]", "[1,3]".
std::string subscript(const Variable& variable, std::size_t k) {
  if (variable.sizes.size() == 1) return fmt::format("[{}]", k + 1);
  const auto columns = static_cast<std::size_t>(variable.sizes[1]);
  return fmt::format("[{},{}]", k / columns + 1, k % columns + 1);
}

/// Returns the offset of the k-th number in memory, which is column-major.
std::size_t place_behind(const Variable& variable, std::size_t k) {
  if (variable.rows == 1) return k;
  const std::size_t columns = variable.count() / static_cast<std::size_t>(variable.rows);
  return k % columns * static_cast<std::size_t>(variable.rows) + k / columns;
}

Variable scalar_of(const Variable& variable, std::size_t k) {
  Variable scalar = variable;
  scalar.sizes.clear();
  scalar.rows = 1;
  const std::string index = subscript(variable, k);
  const bool slope = variable.kind == Kind::slope && variable.name.ends_with(')');
  scalar.name =
      slope ? variable.name.substr(0, variable.name.size() - 1) + index + ")" : variable.name + index;
  scalar.place = fmt::format("{} + {}", variable.place, place_behind(variable, k));
  if (!variable.start.empty()) scalar.start = {variable.start[k]};
  return scalar;
}

}  // namespace

std::vector<Variable> scalars_of(const std::vector<Variable>& variables) {
  std::vector<Variable> scalars;
  std::vector<int> first;  // index of the first scalar of each variable
  for (const Variable& variable : variables) {
    first.push_back(static_cast<int>(scalars.size()));
    if (variable.kind == Kind::indicator) continue;
    for (std::size_t k = 0; k < variable.count(); ++k) {
      scalars.push_back(variable.sizes.empty() ? variable : scalar_of(variable, k));
      if (variable.derivative_of >= 0)
        scalars.back().derivative_of =
            first[static_cast<std::size_t>(variable.derivative_of)] + static_cast<int>(k);
    }
  }
  return scalars;
}

}  // namespace stepwire::fmu
