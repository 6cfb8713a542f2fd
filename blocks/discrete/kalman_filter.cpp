#include "blocks/discrete/kalman_filter.hpp"

#include <algorithm>

#include "engine/model/block/declare_linear_system.hpp"

namespace stepwire {

namespace {

void declare_model(Declare<KalmanFilter>& is) {
  using Block = KalmanFilter;
  declare_linear_system(is, true);
  is.parameter<&Block::Q>({.unit = "*",
                           .shape = "n x n",
                           .doc = "covariance of what disturbs the states from tick to tick",
                           .required = true});
  is.parameter<&Block::R>(
      {.unit = "*", .shape = "p x p", .doc = "covariance of the measurement's noise", .required = true});
  is.parameter<&Block::P0>(
      {.unit = "*", .shape = "n x n", .doc = "covariance of the initial state; zero where left out"});
}

}  // namespace

void KalmanFilter::declare(Declare<KalmanFilter>& is) {
  is.block(
      "KalmanFilter",
      {.doc = "Estimates the states of x[k+1] = A x[k] + B u[k] + w[k] from y[k] = C x[k] + D u[k] + v[k], "
              "where w "
              "has covariance Q and v has R. At each tick the measurement corrects what was expected, "
              "estimate = "
              "x + K (y - C x - D u) with K = P C' (C P C' + R)^-1, and both go on: x = A estimate + B u, "
              "P = A (I - K C) P A' + Q (computed in Joseph's form). The gain varies from P0 on. Its numbers "
              "are "
              "SI of what is wired; the section `units` says what its estimates are in, as units: "
              "{kf.estimate.1: m}. A constant gain: DiscreteLuenbergerObserver.",
       .source = "R. E. Kalman, J. Basic Eng. 82 (1960) 35; Joseph's form: Bucy, Joseph, Filtering for "
                 "Stochastic Processes, 1968",
       .symbol = {.text = "Kalman"}});
  declare_model(is);
  is.input<&KalmanFilter::measured>({.unit = "*", .shape = "p", .doc = "the measurement y"});
  is.input<&KalmanFilter::u>(
      {.unit = "*", .shape = "m", .doc = "known inputs; felt at once only through D", .optional = true});
  is.output<&KalmanFilter::estimate>(
      {.unit = "*", .shape = "n", .doc = "states, this tick's measurement included"});
  is.output<&KalmanFilter::innovation>(
      {.unit = "*", .shape = "p", .doc = "measurement less what was expected of it"});
  is.state<&KalmanFilter::x>({.unit = "*", .shape = "n", .doc = "states expected before the measurement"});
  is.state<&KalmanFilter::P>({.unit = "*", .shape = "n x n", .doc = "their covariance", .settable = false});
  is.state<&KalmanFilter::K>({.unit = "*", .shape = "n x p", .doc = "gain of this tick", .settable = false});
  is.state<&KalmanFilter::first_gain>(
      {.unit = "*", .shape = "n x p", .doc = "gain of the first tick", .settable = false});
  is.state<&KalmanFilter::work>({.unit = "*", .shape = "w", .doc = "space to work in", .settable = false});
  declare_reset(is, "*", "the states and their covariance", "n");
  is.diagnostic<&KalmanFilter::not_positive>(
      {.doc = "the covariance of the innovation is not positive definite; Q, R and P0 must be covariances",
       .ends_run = true});
  is.clock<&KalmanFilter::t>();
}

void KalmanFilter::configure(Configure& is) {
  configure_reset(*this, is);
  configure_linear_system(*this, is);
  is.feedthrough<&KalmanFilter::u, &KalmanFilter::estimate>(direct);
  is.feedthrough<&KalmanFilter::u, &KalmanFilter::innovation>(direct);
  const Index n = A.rows(), p = C.rows();
  is.size("w", std::max(2 * n * n, n * p + p * p) + n * p);
}

}  // namespace stepwire
