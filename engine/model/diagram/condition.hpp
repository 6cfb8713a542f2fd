#pragma once

#include <string>
#include <vector>

#include "engine/base/expression/language.hpp"  // for compiled formulas
#include "engine/base/math/function.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire::diagram {

/// Block for `enable` or `trigger` with a formula of signals: "door.angle > 5 deg && time > 2 s". It has a
/// crossing where its truth changes.
struct Condition {
  static constexpr Index max_inputs = 64;

  Text expression = Text::literal<"u1">();
  std::vector<std::string> variables{};  ///< names of the inputs in the formula
  Inputs u{};
  Output<1> y{};
  Time time{};
  Function formula{}, margin{};  ///< of the inputs, followed by the time

  void outputs() { y = value_of(formula); }
  void crossings(Crossings& zero) const { zero.add(value_of(margin)); }

  void configure(Configure& is);
  static void declare(Declare<Condition>& is);

 private:
  double value_of(const Function& function) const {
    double values[max_inputs + 1];
    for (Index i = 0; i < u.count(); ++i) values[i] = u.first(i);
    values[u.count()] = time;
    return function(values);
  }
};

}  // namespace stepwire::diagram
