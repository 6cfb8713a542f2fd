#pragma once

#include <array>

#include "engine/base/expression/language.hpp"  // for formulas that are code
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/signal/texts.hpp"

namespace stepwire {

/// Formula of its inputs, element by element: y = expression(u1, u2, ...).
template <class Function>
struct ExpressionOf {
  static constexpr Index max_inputs = 64;
  static constexpr Index max_conditions = 4;  ///< located conditions; others act at ticks
  using Functions = std::array<Function, static_cast<std::size_t>(max_conditions)>;

  Text expression = Text::literal<"u1">();
  Texts variables{};
  Inputs u{};
  Output<> y{};
  DiscreteState<> modes{};  // Branches of the formula at the last instant, one row for each jump.

  Function formula{};   ///< of one element of each input
  Functions margins{};  ///< of the same: 0 where a condition changes
  Function held{};      ///< of the same, and of the modes
  Functions modes_of{};
  bool holds_modes = false;  // Between instants y follows the modes.

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) y[k] = holds_modes ? held_value(k) : value_of(formula, k);
  }
  void outputs_at_instant() {
    for (Index m = 0; m < mode_count(); ++m)
      for (Index k = 0; k < y.size(); ++k)
        modes[m * y.size() + k] = value_of(modes_of[static_cast<std::size_t>(m)], k);
    for (Index k = 0; k < y.size(); ++k) y[k] = value_of(formula, k);
  }
  void crossings(Crossings& zero) const {
    for (const Function& margin : margins)
      for (Index k = 0; k < y.size(); ++k) zero.add(value_of(margin, k));
  }

  void configure(Configure& is);
  static void declare(Declare<ExpressionOf>& is);

 private:
  Index mode_count() const { return modes.size() / y.size(); }
  double value_of(const Function& function, Index k) const {
    double values[max_inputs];
    u.gather(k, values);
    return function(values);
  }
  double held_value(Index k) const {
    double values[max_inputs + max_conditions];
    u.gather(k, values);
    for (Index m = 0; m < mode_count(); ++m) values[max_inputs + m] = modes[m * y.size() + k];
    return held(values);
  }
};

using ExpressionBlock = ExpressionOf<Function>;

}  // namespace stepwire
