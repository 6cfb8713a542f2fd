#include "engine/model/diagram/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stepwire::diagram {

namespace {

/// True for an axis of the grid: one without a group, or the last axis of its group.
bool counts(const std::vector<Sweep::Axis>& axes, std::size_t axis) {
  const Sweep::Group group = axes[axis].group;
  const auto behind = axes.begin() + static_cast<std::ptrdiff_t>(axis) + 1;
  return group == Sweep::Group::none ||
         std::ranges::find(behind, axes.end(), group, &Sweep::Axis::group) == axes.end();
}

/// Evenly chosen rows of a table, including the first and the last one.
struct ChosenRows {
  std::size_t rows, chosen;

  std::size_t at(std::size_t i) const { return chosen == 1 ? 0 : i * (rows - 1) / (chosen - 1); }
  bool has(std::size_t row) const {
    if (chosen <= 1) return row < chosen;
    return at((row * (chosen - 1) + rows - 2) / (rows - 1)) == row;
  }
};

std::size_t cases_at_once(const Sweep& sweep) {
  return std::max<std::size_t>(sweep.cases().size(), 1);
}

ChosenRows recorded_rows(const Sweep& sweep) {
  const std::size_t rows = static_cast<std::size_t>(sweep.count()) / cases_at_once(sweep);
  return {rows, std::min(sweep.recorded_runs, rows)};
}

}  // namespace

SweptValues::SweptValues(std::vector<std::string> texts, std::vector<yaml::Mark> marks,
                         std::vector<std::uint32_t> which)
    : texts_(std::move(texts)), marks_(std::move(marks)), which_(std::move(which)) {
  marks_.resize(texts_.size());
}

SweptValues::SweptValues(std::vector<double> numbers, const std::string& unit, const yaml::Mark& mark)
    : marks_{mark},
      numbers_(std::move(numbers)),
      unit_text_(unit),
      unit_(unit::parse_unit(unit).value_or(unit::Unit{})) {}

std::size_t SweptValues::size() const {
  if (!numbers_.empty()) return numbers_.size();
  return which_.empty() ? texts_.size() : which_.size();
}

std::string SweptValues::text(std::size_t value) const {
  if (!are_numbers()) return texts_[which(value)];
  return fmt::format("{}{}{}", numbers_[value], unit_text_.empty() ? "" : " ", unit_text_);
}

yaml::Mark SweptValues::mark(std::size_t value) const {
  return marks_[are_numbers() ? 0 : which(value)];
}

double SweptValues::number(std::size_t value) const {
  return unit_text_.empty() ? numbers_[value] : unit_.to_si(numbers_[value]);
}

std::optional<unit::Dimension> SweptValues::dimension() const {
  if (are_numbers()) return unit_text_.empty() ? std::nullopt : std::optional(unit_.dimension);
  for (const std::string& text : texts_)
    if (const auto quantity = unit::parse_quantity(text); quantity && quantity->dimension)
      return quantity->dimension;
  return std::nullopt;
}

double Sweep::count() const {
  if (axes.empty()) return 0.0;
  double count = together ? 0.0 : 1.0;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const auto values = static_cast<double>(axes[axis].count());
    if (together)
      count = std::max(count, values);
    else if (counts(axes, axis))
      count *= values;
  }
  return count;
}

std::vector<std::size_t> Sweep::indices(std::size_t point) const {
  std::vector<std::size_t> result(axes.size(), point);
  if (together) return result;
  std::size_t of_group[3] = {};
  for (std::size_t axis = axes.size(); axis-- > 0;) {
    std::size_t& index = of_group[static_cast<std::size_t>(axes[axis].group)];
    if (counts(axes, axis)) {
      index = point % axes[axis].count();
      point /= axes[axis].count();
    }
    result[axis] = index;
  }
  return result;
}

std::vector<std::string> Sweep::cases() const {
  std::vector<std::string> names;
  for (const Axis& axis : axes)
    for (std::size_t i = 0; axis.label && axis.of_cases() && i < axis.count(); ++i)
      names.push_back(axis.text(i));
  return names;
}

bool Sweep::records_rows_of(std::size_t point) const {
  return recorded_runs > 0 && recorded_rows(*this).has(point / cases_at_once(*this));
}

std::vector<std::size_t> Sweep::recorded_points() const {
  std::vector<std::size_t> points;
  if (recorded_runs == 0) return points;
  const std::size_t cases = cases_at_once(*this);
  const ChosenRows rows = recorded_rows(*this);
  for (std::size_t i = 0; i < rows.chosen; ++i)
    for (std::size_t one = 0; one < cases; ++one) points.push_back(rows.at(i) * cases + one);
  return points;
}

}  // namespace stepwire::diagram
