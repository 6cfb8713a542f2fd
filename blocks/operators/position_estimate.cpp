#include "blocks/operators/position_estimate.hpp"

#include "blocks/operators/precision_count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void PositionEstimate::configure(Configure& is) {
  require_precision_of_each<&PositionEstimate::measured, &PositionEstimate::precision>(is, "channel");
}

void PositionEstimate::declare(Declare<PositionEstimate>& is) {
  is.block(
      "PositionEstimate",
      {.doc = "Where a hand believes to be, from what its forward model predicts and from what its senses "
              "measure at each tick: a Kalman filter that weighs each by one over its variance. The model is "
              "trusted to a share of the way that it has moved since the last tick. A channel of precision 0 "
              "says nothing then; with the first measurement nothing else is known.",
       .source = "Wolpert, Ghahramani and Jordan 1995, Science 269:1880; weights: Ernst and Banks 2002, "
                 "Nature 415:429",
       .timing = Timing::discrete});
  is.parameter<&PositionEstimate::doubt>(
      {.doc = "deviation of the predicted motion as a share of it", .at_least = 0.0});
  is.input<&PositionEstimate::model>({.unit = "m", .doc = "predicted position, of which the change counts"});
  is.input<&PositionEstimate::measured>({.unit = "m", .doc = "position that each channel measures, x and y"});
  is.input<&PositionEstimate::precision>(
      {.unit = "1/m^2", .doc = "of each, along an axis; 0: it says nothing"});
  is.output<&PositionEstimate::y>({.unit = "m", .doc = "the estimate"});
  is.output<&PositionEstimate::variance>({.unit = "m^2", .doc = "of its error, along an axis"});
  is.state<&PositionEstimate::before>({.unit = "m", .doc = "estimate at the last tick", .settable = false});
  is.state<&PositionEstimate::last>({.unit = "m", .doc = "predicted position there", .settable = false});
  is.state<&PositionEstimate::spread>({.unit = "m^2", .doc = "variance there", .settable = false});
  is.state<&PositionEstimate::begun>({.doc = "1 after the first tick", .settable = false});
}

}  // namespace stepwire
