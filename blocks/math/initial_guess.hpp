#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Passes its input on, y = u. In an algebraic loop its parameter is the initial guess of the solution.
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
