#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/sizes.hpp"

namespace stepwire::plan {

/// The sizes of all ports, states and parameters of a draft, found by the letters of the declared shapes.
class PortSizes : public Sizes {
 public:
  explicit PortSizes(const Draft& draft) : draft_(draft), symbols_(draft.blocks.size()) {}

  /// The size behind a letter or a number in the shapes of one block.
  int symbol(std::size_t block, const std::string& text);
  /// The size of the output that feeds, whole.
  int of_output(const diagram::Source& source);
  /// The size of what feeds; a new one for constants and elements.
  int of_source(const diagram::Source& source);
  /// Makes the declared shape of a port known, where it is that of a matrix.
  bool declare_matrix(std::size_t block, const std::string& shape);
  /// The size of a list input as a whole.
  int of_list(std::size_t block, std::size_t input);
  /// How many elements feed, where that is known.
  std::optional<Eigen::Index> value_of(const diagram::Source& source);

 private:
  const Draft& draft_;
  std::vector<std::vector<std::pair<std::string, int>>> symbols_;
};

}  // namespace stepwire::plan
