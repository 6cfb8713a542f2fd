#pragma once

#include <string>
#include <vector>

#include "engine/base/expression/language.hpp"  // for formulas that are code
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// A formula over its inputs, element by element: y = expression(u1, u2, ...).
struct ExpressionBlock {
  static constexpr Index max_inputs = 64;

  Text expression = Text::literal<"u1">();
  std::vector<std::string> variables{};
  Inputs u{};
  Output<> y{};
  Function formula{};  ///< of one element of each input

  void outputs() {
    double values[max_inputs];
    for (Index k = 0; k < y.size(); ++k) {
      for (Index i = 0; i < u.count(); ++i) values[i] = u[i][k];
      y[k] = formula(values);
    }
  }

  void configure(Configure& is);
  static void declare(Declare<ExpressionBlock>& is);
};

}  // namespace stepwire
