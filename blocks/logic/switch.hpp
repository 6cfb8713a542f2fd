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
  DiscreteState<1> branch{};  // of the last instant

  bool holds_branch = false;  // Between instants y follows the branch.

  void outputs() { pass(holds_branch ? branch > 0.0 : holds()); }
  void outputs_at_instant() {
    branch = holds() ? 1.0 : 0.0;
    pass(branch > 0.0);
  }

  void crossings(Crossings& zero) const { zero.add(control - threshold); }

  void configure(Configure& is);
  static void declare(Declare<Switch>& is);

 private:
  void pass(bool on) {
    if (on) {
      y = then;
    } else {
      y = else_;
    }
  }
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
