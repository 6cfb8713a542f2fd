#include "engine/model/plan/port_sizes.hpp"

#include <charconv>

#include "engine/model/plan/port_shape.hpp"

namespace stepwire::plan {

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
