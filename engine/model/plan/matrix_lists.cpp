#include "engine/model/plan/matrix_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/text/count.hpp"
#include "engine/model/plan/infer_list_widths.hpp"
#include "engine/model/plan/shape_checks.hpp"

namespace stepwire::plan {

void MatrixLists::add(std::size_t block, std::size_t input) {
  const PortShape shape(draft_.type(block).inputs[input].shape);
  List list{block, input, shape, sizes_.symbol(block, shape.adds_rows ? shape.rows : shape.columns), {}, {}};
  const int shared = sizes_.symbol(block, shape.adds_rows ? shape.columns : shape.rows);
  for (const diagram::Source& source : draft_.diagram().blocks[block].inputs[input]) {
    list.parts.push_back(sizes_.add());
    list.elements.push_back(add_element(list, shared, source));
  }
  lists_.push_back(std::move(list));
}

int MatrixLists::add_element(const List& list, int shared, const diagram::Source& source) {
  const int element = sizes_.add(), own = list.parts.back();
  sizes_.set_factors(element, list.shape.adds_rows ? own : shared, list.shape.adds_rows ? shared : own);
  const int given = sizes_.of_source(source);
  const std::string shown = sizes_.shown(given);
  if (!sizes_.join(given, element))
    draft_.report.add(source.origin, subject(list),
                      fmt::format("{} has {}, but {} would fit", quoted_source(draft_, source), shown,
                                  sizes_.fitting(element)));
  return element;
}

bool MatrixLists::add_up() {
  bool any = false;
  for (const List& list : lists_) {
    const auto is_known = [&](int part) { return sizes_.value(part).has_value(); };
    if (sizes_.value(list.sum) || !std::all_of(list.parts.begin(), list.parts.end(), is_known)) continue;
    Eigen::Index sum = 0;
    for (const int part : list.parts) sum = std::min(sum + *sizes_.value(part), max_numbers + 1);
    sizes_.set(list.sum, sum);
    any = true;
  }
  return any;
}

std::vector<std::pair<int, int>> MatrixLists::sums() const {
  std::vector<std::pair<int, int>> all;
  for (const List& list : lists_)
    for (const int part : list.parts) all.emplace_back(list.sum, part);
  return all;
}

void MatrixLists::check() {
  for (const List& list : lists_) {
    check_elements(list);
    check_sum(list);
  }
}

void MatrixLists::check_sum(const List& list) {
  Eigen::Index sum = 0;
  for (const int part : list.parts) sum = std::min(sum + sizes_.value(part).value_or(1), max_numbers + 1);
  const Eigen::Index fitting = sizes_.value(list.sum).value_or(1);
  if (sum != fitting)
    draft_.report.add(draft_.diagram().blocks[list.block].origin, subject(list),
                      fmt::format("has {} {} together; {} would fit", sum,
                                  list.shape.adds_rows ? "rows" : "columns", fitting));
}

void MatrixLists::check_elements(const List& list) {
  const auto& sources = draft_.diagram().blocks[list.block].inputs[list.input];
  for (std::size_t i = 0; i < list.elements.size(); ++i) {
    const auto [rows, columns] = *sizes_.factors(list.elements[i]);
    const Eigen::Index high = sizes_.value(rows).value_or(1), wide = sizes_.value(columns).value_or(1),
                       size = sizes_.value(list.elements[i]).value_or(1);
    if (bounded_product(high, wide) == size) continue;
    const bool by_rows = list.shape.adds_rows;
    draft_.report.add(
        sources[i].origin, subject(list),
        fmt::format("{} has {}, which are no whole {} of {}", quoted_source(draft_, sources[i]),
                    text::counted(size, "element"), by_rows ? "rows" : "columns", by_rows ? wide : high));
  }
}

std::string MatrixLists::subject(const List& list) const {
  return draft_.diagram().blocks[list.block].name + "." + draft_.type(list.block).inputs[list.input].name;
}

}  // namespace stepwire::plan
