#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Logic gate: 1 if its operator holds for its inputs, else 0. True is above 0.
struct Logic {
  enum class Operator { and_, or_, not_, nand, nor, xor_, xnor };

  Operator operator_ = Operator::and_;
  Inputs u{};
  Output<> y{};

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) y[k] = holds(k) ? 1.0 : 0.0;
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.count(); ++i)
      for (Index k = 0; k < y.size(); ++k) zero.add(u[i][k]);
  }

  static void declare(Declare<Logic>& is);
  void configure(Configure& is);

 private:
  bool holds(Index k) const {
    Index truths = 0;
    for (Index i = 0; i < u.count(); ++i) truths += u[i][k] > 0.0;
    switch (operator_) {
      case Operator::and_:
        return truths == u.count();
      case Operator::nand:
        return truths != u.count();
      case Operator::or_:
        return truths > 0;
      case Operator::xor_:
        return truths % 2 == 1;
      case Operator::xnor:
        return truths % 2 == 0;
      default:
        return truths == 0;
    }
  }
};

}  // namespace stepwire
