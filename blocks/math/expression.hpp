#pragma once

#include <array>

#include "engine/base/expression/language.hpp"  // for formulas that are code
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/signal/texts.hpp"

namespace stepwire {

/// Formula of its inputs, element by element: y = expression(u1, u2, ...).
struct ExpressionBlock {
  static constexpr Index max_inputs = 64;
  static constexpr std::size_t max_conditions = 4;  ///< located conditions; others act at ticks

  Text expression = Text::literal<"u1">();
  Texts variables{};
  Inputs u{};
  Output<> y{};
  Function formula{};                              ///< of one element of each input
  std::array<Function, max_conditions> margins{};  ///< of the same: 0 where a condition changes

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) y[k] = value_of(formula, k);
  }
  void crossings(Crossings& zero) const {
    for (const Function& margin : margins)
      for (Index k = 0; k < y.size(); ++k) zero.add(value_of(margin, k));
  }

  void configure(Configure& is);
  static void declare(Declare<ExpressionBlock>& is);

 private:
  double value_of(const Function& function, Index k) const {
    double values[max_inputs];
    for (Index i = 0; i < u.count(); ++i) values[i] = u[i][k];
    return function(values);
  }
};

}  // namespace stepwire
