#include "engine/analyse/coverage/table_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "engine/base/expression/expression.hpp"

namespace stepwire::coverage {
namespace {

constexpr std::size_t most_cells = 400;  // beyond, a list of cells is no help to readers

std::vector<double> numbers_of(const Value& value) {
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content))
    return {vector->data(), vector->data() + vector->size()};
  std::vector<double> numbers;
  if (value.list())
    for (const Value& one : *value.list())
      if (one.text())
        numbers.push_back(expression::Expression(*one.text(), [](std::string_view) { return false; })({}));
  return numbers;
}

}  // namespace

std::optional<std::size_t> TableRegions::Axis::interval(const double* values, std::size_t element) const {
  const double argument = values[place + (size == 1 ? 0 : element)];
  if (!(argument >= points.front() && argument <= points.back())) return std::nullopt;
  const auto above = std::ranges::upper_bound(points, argument);
  const auto index = static_cast<std::size_t>(above - points.begin());
  return std::min(index, points.size() - 1) - 1;
}

std::string TableRegions::Axis::name(std::size_t interval) const {
  return fmt::format("{} from {:.6g} to {:.6g}", input, points[interval], points[interval + 1]);
}

std::optional<TableRegions::Axis> TableRegions::axis_of(const diagram::DiagramBlock& block,
                                                        const plan::PlannedBlock& planned, const char* input,
                                                        const char* points) {
  const ParameterSpec* parameter = block.type().parameter(points);
  const int index = block.type().input(input);
  if (!parameter || index < 0) return std::nullopt;
  const auto& slots = planned.inputs[static_cast<std::size_t>(index)];
  std::vector<double> numbers = numbers_of(parameter->get(block.block.get()));
  if (slots.size() != 1 || numbers.size() < 2) return std::nullopt;
  return Axis{input, slots[0].offset, static_cast<std::size_t>(slots[0].size), std::move(numbers)};
}

/// Adds the axes of a table with a list of inputs, whose points are a list for each.
void TableRegions::add_axes(const diagram::DiagramBlock& block, const plan::PlannedBlock& planned) {
  const ParameterSpec* parameter = block.type().parameter("points");
  const int input = block.type().input("u");
  if (!parameter || input < 0) return;
  const Value points = parameter->get(block.block.get());
  const auto& slots = planned.inputs[static_cast<std::size_t>(input)];
  if (!points.list() || points.list()->size() != slots.size()) return;
  for (std::size_t d = 0; d < slots.size(); ++d)
    axes_.push_back({fmt::format("u{}", d + 1), slots[d].offset, static_cast<std::size_t>(slots[d].size),
                     numbers_of((*points.list())[d])});
}

std::optional<TableRegions> TableRegions::of(const diagram::DiagramBlock& block,
                                             const plan::PlannedBlock& planned) {
  TableRegions regions;
  for (const auto& [input, points] : {std::pair{"u", "points"}, {"row", "rows"}, {"column", "columns"}})
    if (auto axis = axis_of(block, planned, input, points)) regions.axes_.push_back(std::move(*axis));
  if (regions.axes_.empty()) regions.add_axes(block, planned);
  if (regions.axes_.empty()) return std::nullopt;
  regions.name_regions();
  return regions;
}

void TableRegions::name_regions() {
  std::size_t cells = 1;
  for (const Axis& axis : axes_)
    if (cells <= most_cells) cells *= axis.points.size() - 1;
  has_cells_ = axes_.size() == 1 || cells <= most_cells;
  if (has_cells_) {
    names_.assign(cells, "");
    for (std::size_t cell = 0; cell < cells; ++cell)
      for (std::size_t rest = cell, a = axes_.size(); a-- > 0;) {
        const std::size_t count = axes_[a].points.size() - 1;
        names_[cell] = axes_[a].name(rest % count) + (names_[cell].empty() ? "" : ", ") + names_[cell];
        rest /= count;
      }
    return;
  }
  for (const Axis& axis : axes_)
    for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) names_.push_back(axis.name(i));
}

void TableRegions::add_element(const double* values, std::size_t element,
                               std::vector<std::size_t>& found) const {
  std::size_t cell = 0, first = 0;
  bool is_inside = true;
  for (const Axis& axis : axes_) {
    const auto interval = axis.interval(values, element);
    if (!has_cells_ && interval) found.push_back(first + *interval);
    is_inside = is_inside && interval;
    cell = cell * (axis.points.size() - 1) + interval.value_or(0);
    first += axis.points.size() - 1;
  }
  if (has_cells_ && is_inside) found.push_back(cell);
}

std::vector<std::size_t> TableRegions::at(const double* values) const {
  std::size_t elements = 1;
  for (const Axis& axis : axes_) elements = std::max(elements, axis.size);
  std::vector<std::size_t> found;
  for (std::size_t element = 0; element < elements; ++element) add_element(values, element, found);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace stepwire::coverage
