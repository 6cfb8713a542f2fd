#include "engine/analyse/estimation/row_values.hpp"

namespace stepwire::estimation {

std::vector<double> values_of(const query::Formula& formula, const record::Recording& recording) {
  if (formula.columns.size() == 1 && formula.text == formula.expression.variables().front())
    if (const table::Column* column = recording.table.find(formula.columns.front())) return column->values;
  return query::evaluate(formula, recording);
}

}  // namespace stepwire::estimation
