#include "engine/analyse/study/sequence_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace stepwire::study {

namespace {

/// Returns the column of a carried parameter. A swept one already has a column for its value in the first
/// trial.
std::string column_of(const std::string& parameter, const diagram::Diagram& diagram) {
  const bool swept =
      diagram.sweep && std::ranges::find(diagram.sweep->axes, parameter, &diagram::Sweep::Axis::parameter) !=
                           diagram.sweep->axes.end();
  return swept ? "carried." + parameter : parameter;
}

/// Adds one column per element of a parameter: "memory", or "memory.1", "memory.2".
void add_carried_columns(const std::string& name, const diagram::Diagram& diagram,
                         std::vector<table::Column>& columns) {
  const auto& parameter = *std::ranges::find(diagram.parameters, name, &diagram::DiagramParameter::name);
  const std::string unit = parameter.dimension ? unit::si_name(*parameter.dimension) : "";
  const auto* list = std::get_if<Eigen::VectorXd>(&parameter.value.content);
  const std::string column = column_of(name, diagram);
  if (!list) columns.push_back({column, unit, {}});
  for (Eigen::Index i = 1; list && i <= list->size(); ++i)
    columns.push_back({fmt::format("{}.{}", column, i), unit, {}});
}

}  // namespace

std::vector<table::Column> sequence_columns(const Experiment& experiment, const StudyRequest& request,
                                            const diagram::Diagram& diagram) {
  std::vector<table::Column> columns{{"order", "", {}}};
  for (const CarriedValue& carried : request.carry) add_carried_columns(carried.parameter, diagram, columns);
  for (const TrialRun& run : experiment.runs) {
    std::vector<double> numbers{static_cast<double>(run.order)};
    for (const std::vector<double>& values : run.begun)
      numbers.insert(numbers.end(), values.begin(), values.end());
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(numbers[i]);
  }
  for (table::Column& column : columns)
    column.values.resize(experiment.trials.size(), std::numeric_limits<double>::quiet_NaN());
  return columns;
}

}  // namespace stepwire::study
