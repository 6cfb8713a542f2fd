#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// y = u, and where an algebraic loop goes through it, what the search for its solution begins with.
struct InitialGuess {
  PerElement guess = 0.0;
  Input<> u{};
  Output<> y{};

  void outputs() { y = u; }
  void start() {
    y.each([&](Index i) { return guess[i]; });
  }

  static void declare(Declare<InitialGuess>& is);
};

}  // namespace stepwire
