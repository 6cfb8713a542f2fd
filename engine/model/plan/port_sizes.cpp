#include "engine/model/plan/port_sizes.hpp"

#include <charconv>

namespace stepwire::plan {

int PortSizes::symbol(std::size_t block, const std::string& text) {
  for (const auto& [name, size] : symbols_[block])
    if (name == text) return size;
  const int size = add();
  symbols_[block].emplace_back(text, size);
  Eigen::Index literal = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), literal).ec == std::errc()) set(size, literal);
  return size;
}

int PortSizes::of_output(const diagram::Source& source) {
  const auto block = static_cast<std::size_t>(source.block);
  return symbol(block, draft_.type(block).outputs[static_cast<std::size_t>(source.output)].shape);
}

int PortSizes::of_list(std::size_t block, std::size_t input) {
  const std::string& shape = draft_.type(block).inputs[input].shape;
  return symbol(block, shape.starts_with('+') ? shape.substr(1) : shape);
}

std::optional<Eigen::Index> PortSizes::value_of(const diagram::Source& source) {
  return source.block < 0 ? std::optional(source.constant.size()) : value(of_output(source));
}

}  // namespace stepwire::plan
