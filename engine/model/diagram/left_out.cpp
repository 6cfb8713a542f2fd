#include "engine/model/diagram/left_out.hpp"

#include <optional>

namespace stepwire::diagram {

namespace {

/// Returns the number of a value that is the same for all elements; std::nullopt for other values.
std::optional<double> number_of(const Value& value) {
  if (const double* number = std::get_if<double>(&value.content)) return *number;
  const auto* numbers = std::get_if<Eigen::VectorXd>(&value.content);
  if (numbers && numbers->size() > 0 && (numbers->array() == (*numbers)[0]).all()) return (*numbers)[0];
  return std::nullopt;
}

}  // namespace

bool is_left_out(const DiagramBlock& block, std::size_t parameter) {
  const auto& marks = block.parameter_marks;
  if (parameter < marks.size() && marks[parameter].line > 0) return false;
  if (block.parameter_dimensions[parameter]) return false;
  const ParameterSpec& spec = block.type().parameters[parameter];
  const AnyBlock fresh(block.type());
  const auto own = number_of(spec.get(block.block.get())), of_type = number_of(spec.get(fresh.get()));
  return own && of_type && *own == *of_type;
}

}  // namespace stepwire::diagram
