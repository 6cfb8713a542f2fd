#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Linear system: dx/dt = A x + B u, y = C x + D u.
struct StateSpace : Resettable {
  Matrix A, B, C, D;
  Input<> u{};
  Output<> y{};
  State<> x{};

  bool direct = false;

  void outputs() { show(x); }
  void outputs_at_instant() {
    if (resetting()) {
      show(Targets{*this});
    } else {
      show(x);
    }
  }

  void derivatives() {
    x.derivative = 0.0;
    if (held()) return;
    add(A, x, x.derivative);
    add(B, u, x.derivative);
  }

  /// Runs only if something resets.
  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<StateSpace>& is);

 private:
  template <class States>
  void show(const States& states) {
    y = 0.0;
    add(C, states, y);
    if (direct) add(D, u, y);
  }
  /// Computes to += matrix from, column by column in memory order, without a temporary.
  template <class From, class To>
  static void add(const Matrix& matrix, const From& from, To& to) {
    for (Index j = 0; j < matrix.columns(); ++j) {
      const double factor = from[j];
      for (Index i = 0; i < matrix.rows(); ++i) to[i] += matrix(i, j) * factor;
    }
  }
};

}  // namespace stepwire
