#include "engine/analyse/estimation/row_values.hpp"

namespace stepwire {

std::vector<double> values_of(const Formula& formula, const Recording& recording) {
  if (formula.columns.size() == 1 && formula.text == formula.expression.variables().front())
    if (const Column* column = recording.table.find(formula.columns.front())) return column->values;
  return evaluate(formula, recording);
}

}  // namespace stepwire
