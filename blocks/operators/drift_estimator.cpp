#include "blocks/operators/drift_estimator.hpp"

#include "blocks/operators/precision_count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void DriftEstimator::configure(Configure& is) {
  require_precision_of_each<&DriftEstimator::measured, &DriftEstimator::precision>(is, "channel");
}

void DriftEstimator::declare(Declare<DriftEstimator>& is) {
  is.block(
      "DriftEstimator",
      {.doc = "What can be known of a slow drift in the plane, as of the sense of where one's hand is, from "
              "several channels: a Kalman filter for a drift (Ornstein-Uhlenbeck) of known deviation and "
              "correlation. At each tick each channel measures the drift along `direction`, with noise of "
              "which the precision is known, one over its variance. Precisions add up, that of what was "
              "known before included; a channel of precision 0 says nothing then. At first nothing is "
              "known: the estimate is 0, its variance that of the drift.",
       .source = "Kalman 1960; fusion of cues by one over their variances: Ernst and Banks 2002, Nature 415",
       .timing = Timing::discrete});
  is.parameter<&DriftEstimator::deviation>(
      {.unit = "'u", .doc = "standard deviation of the drift, along any direction", .above = 0.0});
  is.parameter<&DriftEstimator::correlation>(
      {.unit = "'s",
       .doc = "change of `along` over which the drift's correlation falls to 1/e",
       .above = 0.0});
  is.input<&DriftEstimator::measured>({.unit = "'u", .doc = "what each channel measures of the drift"});
  is.input<&DriftEstimator::precision>({.unit = "1/'u^2", .doc = "precision of each; 0: it says nothing"});
  is.input<&DriftEstimator::direction>({.doc = "along which they measure, a unit vector"});
  is.input<&DriftEstimator::along>({.unit = "'s", .doc = "coordinate over which it drifts"});
  is.output<&DriftEstimator::estimate>({.unit = "'u", .doc = "what the drift is most likely, x and y"});
  is.output<&DriftEstimator::covariance>({.unit = "'u^2", .doc = "covariance of its error: xx, xy and yy"});
  is.state<&DriftEstimator::before>({.unit = "'u", .doc = "estimate at the last tick", .settable = false});
  is.state<&DriftEstimator::spread>(
      {.unit = "'u^2", .doc = "covariance at the last tick", .settable = false});
  is.state<&DriftEstimator::last>({.unit = "'s", .doc = "the coordinate there", .settable = false});
  is.state<&DriftEstimator::begun>({.doc = "1 after the first tick", .settable = false});
}

}  // namespace stepwire
