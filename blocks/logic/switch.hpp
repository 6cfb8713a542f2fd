#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Passes on one of two inputs, selected by a third one.
struct Switch {
  enum class Criterion { greater, greater_equal, not_equal };

  double threshold = 0.0;
  Criterion criterion = Criterion::greater;
  Input<1> control{};
  Input<> then{}, else_{};
  Output<> y{};

  void outputs() {
    if (holds()) {
      y = then;
    } else {
      y = else_;
    }
  }

  void crossings(Crossings& zero) const { zero.add(control - threshold); }

  static void declare(Declare<Switch>& is);

 private:
  bool holds() const {
    switch (criterion) {
      case Criterion::greater:
        return control > threshold;
      case Criterion::greater_equal:
        return control >= threshold;
      default:
        return control != threshold;
    }
  }
};

}  // namespace stepwire
