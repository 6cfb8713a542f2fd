#pragma once

#include <string>
#include <vector>

#include "engine/block/block.hpp"
#include "engine/expression/expression.hpp"

namespace stepwire {

/// A formula over its inputs, element by element: y = expression(u1, u2, ...).
struct ExpressionBlock {
  Text expression = "u1";
  Inputs u{};
  Output<> y{};
  Expression formula{"u1"};
  std::vector<Index> input{};   ///< which one each variable of the formula is
  std::vector<double> value{};  ///< of each variable, for one element

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) {
      for (std::size_t i = 0; i < input.size(); ++i) value[i] = u[input[i]][k];
      y[k] = formula(value);
    }
  }

  void configure(Configure& is);
  static void declare(Declare<ExpressionBlock>& is);
};

}  // namespace stepwire
