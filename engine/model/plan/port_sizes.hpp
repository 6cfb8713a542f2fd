#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/sizes.hpp"

namespace stepwire::plan {

/// Sizes of all ports, states and parameters of a draft, by the letters of the declared shapes.
class PortSizes : public Sizes {
 public:
  explicit PortSizes(const Draft& draft) : draft_(draft), symbols_(draft.blocks.size()) {}

  /// Returns the size of a letter or number in the shapes of one block.
  int symbol(std::size_t block, const std::string& text);
  /// Returns the size of the whole output of a source.
  int of_output(const diagram::Source& source);
  /// Returns the size of a source; a new one for constants and elements.
  int of_source(const diagram::Source& source);
  /// Records the rows and columns of a port with a matrix shape; returns false for other shapes.
  bool declare_matrix(std::size_t block, const std::string& shape);
  /// Returns the total size of a list input.
  int of_list(std::size_t block, std::size_t input);
  /// Returns the number of elements of a source; std::nullopt if unknown.
  std::optional<Eigen::Index> value_of(const diagram::Source& source);

 private:
  const Draft& draft_;
  std::vector<std::vector<std::pair<std::string, int>>> symbols_;
};

}  // namespace stepwire::plan
