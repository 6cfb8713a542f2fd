#pragma once

#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Observer with a constant gain: dx/dt = A x + B u + L (y - C x - D u).
struct LuenbergerObserver : LinearObserver {
  State<> x{};

  /// Runs only if something resets, like update().
  void outputs() { show(held()); }
  void outputs_at_instant() { show(resetting()); }

  void derivatives() {
    x.derivative = 0.0;
    if (held()) return;
    dense::add(A, x, x.derivative);
    if (u.connected()) dense::add(B, u, x.derivative);
    for (Index k = 0; k < measured.size(); ++k) correct_by(k);
  }

  void update_before_instant() { follow_target(x); }
  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<LuenbergerObserver>& is);

 private:
  void show(bool at_target) {
    for (Index i = 0; i < estimate.size(); ++i) estimate[i] = at_target ? target(i) : x[i];
  }
  /// Adds the column of L times the innovation of measurement k.
  void correct_by(Index k) {
    double residual = measured[k];
    for (Index j = 0; j < x.size(); ++j) residual -= C(k, j) * x[j];
    if (direct)
      for (Index j = 0; j < u.size(); ++j) residual -= D(k, j) * u[j];
    for (Index i = 0; i < x.size(); ++i) x.derivative[i] += L(i, k) * residual;
  }
};

}  // namespace stepwire
