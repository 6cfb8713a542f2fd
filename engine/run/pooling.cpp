#include "engine/run/pooling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire {

namespace {

/// The swept parameter as it stands in a point's diagram, if it is one.
const DiagramParameter* swept_parameter(const Diagram& diagram, const std::string& name) {
  const auto found = std::find_if(diagram.parameters.begin(), diagram.parameters.end(),
                                  [&](const DiagramParameter& parameter) { return parameter.name == name; });
  return found == diagram.parameters.end() ? nullptr : &*found;
}

/// A swept value as a number: of a parameter as it was evaluated, of a block's key as it was written.
std::optional<Quantity> swept_number(const Sweep::Axis& axis, std::size_t index, const Diagram& diagram) {
  const DiagramParameter* parameter = swept_parameter(diagram, axis.parameter);
  if (!parameter) return parse_quantity(axis.values[index]);
  const double* number = std::get_if<double>(&parameter->value.content);
  return number ? std::optional(Quantity{*number, parameter->dimension}) : std::nullopt;
}

}  // namespace

std::vector<std::size_t> indices_of(const Sweep& sweep, std::size_t point) {
  std::vector<std::size_t> result(sweep.axes.size(), point);
  if (sweep.together) return result;
  for (std::size_t axis = sweep.axes.size(); axis-- > 0;) {
    result[axis] = point % sweep.axes[axis].values.size();
    point /= sweep.axes[axis].values.size();
  }
  return result;
}

std::string settings_text(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", setting.name, setting.value);
  return text;
}

SweptColumns::SweptColumns(const Job& job) : job_(job) {
  if (job.points.empty()) return;
  const Sweep& sweep = *job.plan.diagram.sweep;
  numeric_.assign(sweep.axes.size(), true);
  for (std::size_t point = 0; point < job.points.size(); ++point) {
    const auto index = indices_of(sweep, point);
    for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis)
      if (!swept_number(sweep.axes[axis], index[axis], job.points[point].plan.diagram))
        numeric_[axis] = false;
  }
}

std::vector<Column> SweptColumns::of(std::size_t point) const {
  std::vector<Column> columns;
  if (job_.points.empty()) return columns;
  const Sweep& sweep = *job_.plan.diagram.sweep;
  const auto index = indices_of(sweep, point);
  for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis) {
    const auto number = numeric_[axis]
                            ? swept_number(sweep.axes[axis], index[axis], job_.points[point].plan.diagram)
                            : std::nullopt;
    Column column{
        sweep.axes[axis].parameter, "", {number ? number->value : static_cast<double>(index[axis])}};
    if (number && number->dimension) column.unit = si_name(*number->dimension);
    columns.push_back(std::move(column));
  }
  return columns;
}

void SweptColumns::add(Recording& recording, std::size_t point) const {
  std::vector<Column> columns = of(point);
  for (std::size_t axis = 0; axis < columns.size(); ++axis) {
    columns[axis].values.assign(recording.table.rows(), columns[axis].values.front());
    if (!numeric_[axis])
      recording.words.push_back({columns[axis].name, job_.plan.diagram.sweep->axes[axis].values});
  }
  recording.table.columns.insert(recording.table.columns.begin() + 1, columns.begin(), columns.end());
}

void append_runs(Recording& all, Recording&& more) {
  if (all.table.columns.empty()) {
    all = std::move(more);
    return;
  }
  const std::size_t rows = all.table.rows();
  for (const std::size_t start : more.starts) all.starts.push_back(rows + start);
  for (std::size_t i = 0; i < all.table.columns.size(); ++i) {
    auto& values = all.table.columns[i].values;
    values.insert(values.end(), more.table.columns[i].values.begin(), more.table.columns[i].values.end());
  }
}

}  // namespace stepwire
