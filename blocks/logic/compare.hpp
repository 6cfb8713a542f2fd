#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Comparison: 1 if `u` is less than, equal to, ... `to`, else 0.
struct Compare {
  enum class Relation { less, less_equal, greater, greater_equal, equal, not_equal };
  static constexpr int relations = 6;  // each also has a sign as its name, in the same order after the words

  Relation operator_ = Relation::less;
  Input<> u{}, to{};
  Output<> y{};

  Relation relation = Relation::less;

  void outputs() {
    y.each([&](Index i) { return holds(u[i], to[i]) ? 1.0 : 0.0; });
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i] - to[i]);
  }

  void prepare() { relation = static_cast<Relation>(static_cast<int>(operator_) % relations); }
  static void declare(Declare<Compare>& is);

 private:
  bool holds(double a, double b) const {
    switch (relation) {
      case Relation::less:
        return a < b;
      case Relation::less_equal:
        return a <= b;
      case Relation::greater:
        return a > b;
      case Relation::greater_equal:
        return a >= b;
      case Relation::equal:
        return a == b;
      default:
        return a != b;
    }
  }
};

}  // namespace stepwire
