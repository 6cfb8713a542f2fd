#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/port_shape.hpp"
#include "engine/model/plan/port_sizes.hpp"

namespace stepwire::plan {

/// The inputs that are lists of matrices: side by side ("m x +n"), whose columns add up to n, or one above
/// the other ("+m x n"), whose rows add up to m.
class MatrixLists {
 public:
  explicit MatrixLists(Draft& draft, PortSizes& sizes) : draft_(draft), sizes_(sizes) {}

  /// Takes the list of an input whose shape is that of a matrix.
  void add(std::size_t block, std::size_t input);
  /// Learns the sums of which every part is known by now. True where one is new.
  bool add_up();
  /// Pairs of a sum and one of its parts, which it follows from.
  std::vector<std::pair<int, int>> sums() const;
  /// Once all sizes are found: refuses lists whose sum is another, and elements that have no whole rows.
  void check();

 private:
  struct List {
    std::size_t block, input;
    PortShape shape;
    int sum;
    std::vector<int> parts;     ///< rows or columns of every element
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
