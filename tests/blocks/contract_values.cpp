#include "tests/blocks/contract_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulate/codegen/value_text.hpp"

namespace stepwire {

namespace {

std::string list_text(const double* numbers, Eigen::Index count, Eigen::Index stride) {
  std::string text;
  for (Eigen::Index k = 0; k < count; ++k)
    text += fmt::format("{}{}", k == 0 ? "" : ", ", numbers[k * stride]);
  return "[" + text + "]";
}

bool all_finite(const std::vector<double>& numbers) {
  return !numbers.empty() && std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

/// Where the value that begins here in a map on one line ends.
std::size_t end_of_value(const std::string& text, std::size_t at) {
  for (int depth = 0; at < text.size(); ++at) {
    if (depth == 0 && (text[at] == ',' || text[at] == '}')) return at;
    if (text[at] == '[' || text[at] == '{') ++depth;
    if (text[at] == ']' || text[at] == '}') --depth;
  }
  return at;
}

}  // namespace

std::string yaml_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.content)) return fmt::format("{}", *number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return vector->size() == 1 ? fmt::format("{}", (*vector)[0])
                               : list_text(vector->data(), vector->size(), 1);
  const auto& matrix = std::get<Eigen::MatrixXd>(value.content);
  std::string rows;
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    rows += (r == 0 ? "" : ", ") + list_text(matrix.data() + r, matrix.cols(), matrix.rows());
  return "[" + rows + "]";
}

std::string with_parameters(const Wiring& wiring) {
  return with_parameters(wiring, wiring);
}

std::string with_parameters(const Wiring& wiring, const Wiring& values) {
  const auto plan = plan_of(values);
  if (!plan) return "";
  const std::size_t tested = tested_in(*plan);
  const auto& written = plan->blocks[tested].written;
  const AnyBlock& block = written ? *written : plan->diagram.blocks[tested].block;
  std::string text = wiring.text, parameters;
  for (const ParameterSpec& spec : block.type().parameters) {
    const Value value = spec.get(block.get());
    if (spec.kind == ParameterKind::word || !all_finite(codegen::numbers_of(value))) continue;
    parameters += fmt::format("  p_{}: {}\n", spec.name, yaml_of(value));
    const std::size_t line = text.rfind("  tested: ");
    const std::string key = ", " + spec.name + ": ";
    const std::size_t at = text.find(key, line);
    if (at != std::string::npos) text.erase(at, end_of_value(text, at + key.size()) - at);
    text.insert(text.rfind("}\n"), key + "$p_" + spec.name);
  }
  return parameters.empty() ? "" : text + "parameters:\n" + parameters;
}

Value changed(Value value, double factor, double more, bool whole) {
  const auto change = [&](double& x) { x = whole ? std::round(x * factor) + 1.0 : x * factor + more; };
  if (auto* number = std::get_if<double>(&value.content)) change(*number);
  if (auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    for (double& x : *vector) change(x);
  if (auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content))
    for (double& x : matrix->reshaped()) change(x);
  return value;
}

}  // namespace stepwire
