#include "engine/model/plan/port_sizes.hpp"

#include <fmt/format.h>

#include <charconv>

namespace stepwire::plan {

int Sizes::add() {
  parents_.push_back(static_cast<int>(parents_.size()));
  values_.emplace_back();
  factors_.emplace_back();
  return parents_.back();
}

int Sizes::root(int size) {
  while (parents_[static_cast<std::size_t>(size)] != size) {
    int& parent = parents_[static_cast<std::size_t>(size)];
    parent = parents_[static_cast<std::size_t>(parent)];
    size = parent;
  }
  return size;
}

bool Sizes::set(int size, Eigen::Index value) {
  auto& known = values_[static_cast<std::size_t>(root(size))];
  if (known) return *known == value;
  known = value;
  return true;
}

bool Sizes::join(int a, int b) {
  const int first = root(a), second = root(b);
  if (first == second) return true;
  const auto value_a = values_[static_cast<std::size_t>(first)],
             value_b = values_[static_cast<std::size_t>(second)];
  const auto matrix = factors_[static_cast<std::size_t>(first)],
             other = factors_[static_cast<std::size_t>(second)];
  if (value_a && value_b && *value_a != *value_b) return false;
  if (matrix && other && !(join(matrix->first, other->first) && join(matrix->second, other->second)))
    return false;
  parents_[static_cast<std::size_t>(first)] = second;
  if (value_a) values_[static_cast<std::size_t>(second)] = value_a;
  if (matrix) factors_[static_cast<std::size_t>(second)] = matrix;
  return true;
}

bool Sizes::set_factors(int size, int rows, int columns) {
  matrices_ = true;
  auto& known = factors_[static_cast<std::size_t>(root(size))];
  if (known) return join(known->first, rows) && join(known->second, columns);
  known = {rows, columns};
  return true;
}

Eigen::Index Sizes::columns(int size) {
  const auto& matrix = factors(size);
  return matrix ? value(matrix->second).value_or(1) : 1;
}

bool Sizes::set_if_open(int size, Eigen::Index value) {
  if (this->value(size)) return false;
  return set(size, value);
}

bool Sizes::multiply(int size) {
  const auto [rows, columns] = *factors(size);
  const auto all = value(size), high = value(rows), wide = value(columns);
  if (high && wide) return set_if_open(size, *high * *wide);
  if (all == 1) {  // one number is one row of one column
    const bool new_rows = set_if_open(rows, 1);
    return set_if_open(columns, 1) || new_rows;
  }
  if (all && high && *high > 0 && *all % *high == 0) return set_if_open(columns, *all / *high);
  if (all && wide && *wide > 0 && *all % *wide == 0) return set_if_open(rows, *all / *wide);
  return false;
}

bool Sizes::multiply() {
  bool any = false;
  for (bool more = matrices_; more;) {
    more = false;
    for (int size = 0; size < count(); ++size)
      if (root(size) == size && factors(size)) more = multiply(size) || more;
    any = any || more;
  }
  return any;
}

bool Sizes::settle_columns() {
  for (int size = 0; matrices_ && size < count(); ++size)
    if (root(size) == size && factors(size) && value(size) && set_if_open(factors(size)->second, 1))
      return true;
  return false;
}

std::string Sizes::shown(int size) {
  const auto number = [&](int of) {
    const auto known = value(of);
    return known ? fmt::format("{}", *known) : std::string("?");
  };
  const auto& matrix = factors(size);
  if (!matrix || (value(matrix->second) && value(matrix->second) == 1)) return number(size) + " elements";
  return number(matrix->first) + " x " + number(matrix->second) + " elements";
}

std::string Sizes::fitting(int size) {
  const std::string text = shown(size);
  return text.substr(0, text.rfind(' '));
}

int PortSizes::symbol(std::size_t block, const std::string& text) {
  for (const auto& [name, size] : symbols_[block])
    if (name == text) return size;
  const int size = add();
  symbols_[block].emplace_back(text, size);
  Eigen::Index literal = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, literal);
  if (error == std::errc() && rest == end) set(size, literal);
  return size;
}

int PortSizes::of_output(const diagram::Source& source) {
  const auto block = static_cast<std::size_t>(source.block);
  return symbol(block, draft_.type(block).outputs[static_cast<std::size_t>(source.output)].shape);
}

int PortSizes::of_source(const diagram::Source& source) {
  if (source.block >= 0 && source.element.is_whole()) return of_output(source);
  const int size = add();
  const Eigen::Index elements = source.element.is_whole() ? source.constant.size() : 1;
  set(size, elements);
  if (!source.element.is_whole() || source.columns == 1) return size;
  const int rows = add(), columns = add();
  set(rows, elements / source.columns);
  set(columns, source.columns);
  set_factors(size, rows, columns);
  return size;
}

bool PortSizes::declare_matrix(std::size_t block, const std::string& text) {
  const PortShape shape(text);
  return !shape.is_matrix ||
         set_factors(symbol(block, text), symbol(block, shape.rows), symbol(block, shape.columns));
}

int PortSizes::of_list(std::size_t block, std::size_t input) {
  const std::string& shape = draft_.type(block).inputs[input].shape;
  return symbol(block, shape.starts_with('+') ? shape.substr(1) : shape);
}

std::optional<Eigen::Index> PortSizes::value_of(const diagram::Source& source) {
  if (!source.element.is_whole()) return 1;
  return source.block < 0 ? std::optional(source.constant.size()) : value(of_output(source));
}

}  // namespace stepwire::plan
