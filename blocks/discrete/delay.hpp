#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Delay by a time of whole periods: y(t) = u(t - delay).
struct Delay {
  double delay = 0.0;
  PerElement initial = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> samples{};  // rows of one sample each, written in a circle
  DiscreteState<1> oldest{};  // row that is given next and then overwritten

  Eigen::Index periods = 1;

  void outputs() {
    const double* row = samples.data() + static_cast<Eigen::Index>(oldest) * y.size();
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = row[i];
  }

  void update() {
    const Eigen::Index row = static_cast<Eigen::Index>(oldest);
    double* place = samples.data() + row * u.size();
    for (Eigen::Index i = 0; i < u.size(); ++i) place[i] = u.coeff(i);
    oldest = row + 1 < periods ? static_cast<double>(row + 1) : 0.0;
  }

  void start() {
    for (Eigen::Index i = 0; i < samples.size(); ++i) samples.coeffRef(i) = initial.coeff(i % initial.size());
  }

  void configure(Configure& is);
  static void declare(Declare<Delay>& is);
};

}  // namespace stepwire
