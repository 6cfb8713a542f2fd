#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/port_sizes.hpp"

namespace stepwire::plan {

/// Inputs that are lists of matrices: side by side ("m x +n"), whose columns sum to n, or above each other
/// ("+m x n"), whose rows sum to m.
class MatrixLists {
 public:
  explicit MatrixLists(Draft& draft, PortSizes& sizes) : draft_(draft), sizes_(sizes) {}

  /// Adds the list of an input with a matrix shape.
  void add(std::size_t block, std::size_t input);
  /// Determines the sums whose parts are all known. Returns true if one is new.
  bool add_up();
  /// Returns pairs of a sum and one of the parts that it depends on.
  std::vector<std::pair<int, int>> sums() const;
  /// Refuses lists with a wrong sum, and elements without complete rows, once all sizes are known.
  void check();

 private:
  struct List {
    std::size_t block, input;
    PortShape shape;
    int sum;
    std::vector<int> parts;     ///< rows or columns of each element
    std::vector<int> elements;  ///< sizes of the elements
  };

  int add_element(const List& list, int shared, const diagram::Source& source);
  std::string subject(const List& list) const;
  void check_sum(const List& list);
  void check_elements(const List& list);

  Draft& draft_;
  PortSizes& sizes_;
  std::vector<List> lists_;
};

}  // namespace stepwire::plan
