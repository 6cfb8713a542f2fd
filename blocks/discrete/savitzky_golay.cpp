#include "blocks/discrete/savitzky_golay.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <array>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

namespace {

/// Returns the coefficients of the derivative at the centre that are exact for every polynomial up to `order`
/// and have the smallest sum of squares. These are those of least squares. Positions are scaled to -1 to 1,
/// so that their powers stay comparable. `interval` is the time between samples [s].
Numbers coefficients_of(Index window, Index order, Index derivative, double interval) {
  const Index half = (window - 1) / 2;
  Eigen::MatrixXd powers(order + 1, window);
  for (Index k = 0; k < window; ++k) {
    const double place = static_cast<double>(k - half) / static_cast<double>(half);
    for (Index power = 0; power <= order; ++power)
      powers(power, k) = fn::pow(place, static_cast<double>(power));
  }
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(order + 1);
  const double factorial = derivative == 2 ? 2.0 : 1.0;
  wanted(derivative) =
      factorial / fn::pow(static_cast<double>(half) * interval, static_cast<double>(derivative));
  const Eigen::VectorXd result = powers.completeOrthogonalDecomposition().solve(wanted);
  return {result.data(), result.size()};
}

}  // namespace

void SavitzkyGolay::configure(Configure& is) {
  if (window % 2 == 0)
    is.refuse<&SavitzkyGolay::window>(
        fmt::format("{} samples have no middle one; it must be odd, e.g. {}", window, window + 1));
  if (order >= window)
    is.refuse<&SavitzkyGolay::order>(
        fmt::format("{} is not below the window of {} samples; nothing would be smoothed", order, window));
  if (derivative > order)
    is.refuse<&SavitzkyGolay::derivative>(
        fmt::format("{} of a polynomial of order {} is 0; give at least that order", derivative, order));
  const std::array<const char*, 3> rates{"1", "1/s", "1/s^2"};
  is.unit("'r", rates[static_cast<std::size_t>(derivative)]);
  configure_reset_input(*this, is);
  is.size("k", window - 1);
  coefficients = coefficients_of(window, order, derivative, is.period());
}

void SavitzkyGolay::declare(Declare<SavitzkyGolay>& is) {
  is.block(
      "SavitzkyGolay",
      {.doc =
           "Smooths or differentiates samples: a polynomial is fitted by least squares to the last N = "
           "window "
           "samples, this tick's included, and its value or derivative in the middle of the window given. So "
           "polynomials up to `order` pass unchanged, late by exactly (N - 1)/2 samples; delay what is "
           "compared "
           "with it alike, by Delay or by the same block with derivative 0. Before the first tick the input "
           "is "
           "taken to have had its first value. Without a lag, but not while it is measured: the step "
           "low_pass in "
           "`prepare` of FromFile.",
       .source = "A. Savitzky and M. J. E. Golay, Anal. Chem. 36 (1964) 1627",
       .symbol = {.text = "polynomial"}});
  is.parameter<&SavitzkyGolay::window>(
      {.doc = "number of samples N, odd", .at_least = 3.0, .at_most = 10001.0});
  is.parameter<&SavitzkyGolay::order>({.doc = "of the polynomial", .at_least = 0.0, .at_most = 10.0});
  is.parameter<&SavitzkyGolay::derivative>(
      {.doc = "0: value, 1: first derivative, per second, 2: second one", .at_least = 0.0, .at_most = 2.0});
  is.input<&SavitzkyGolay::u>({.unit = "'u", .doc = "signal"});
  is.output<&SavitzkyGolay::y>({.unit = "'u 'r", .doc = "smoothed signal or its derivative"});
  is.state<&SavitzkyGolay::samples>(
      {.unit = "'u", .shape = "k x n", .doc = "the window without this tick", .settable = false});
  is.state<&SavitzkyGolay::oldest>({.doc = "where the oldest sample is", .settable = false});
  is.state<&SavitzkyGolay::begun>({.doc = "0 before the first tick, then 1", .settable = false});
  declare_reset_input(is, "the window");
  is.derived<&SavitzkyGolay::coefficients, &SavitzkyGolay::window, &SavitzkyGolay::order,
             &SavitzkyGolay::derivative>();
}

}  // namespace stepwire
