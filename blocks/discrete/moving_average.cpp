#include "blocks/discrete/moving_average.hpp"

#include "engine/model/block/declare_reset.hpp"

#include "blocks/discrete/whole_periods.hpp"

namespace stepwire {

void MovingAverage::declare(Declare<MovingAverage>& is) {
  is.block(
      "MovingAverage",
      {.doc =
           "Mean of the last N samples, this tick's included, with N = window / period, a whole number. "
           "Until "
           "the window is full it is the mean of the samples so far. It removes whatever repeats within the "
           "window (20 ms: mains hum of 50 Hz) and delays by half of it.",
       .symbol = {.text = "mean"}});
  is.parameter<&MovingAverage::window>(
      {.unit = "s", .doc = "length of the window, whole periods", .above = 0.0, .required = true});
  is.input<&MovingAverage::u>({.unit = "'u", .doc = "signal to smooth"});
  is.output<&MovingAverage::y>({.unit = "'u", .doc = "its mean over the window"});
  is.state<&MovingAverage::samples>({.unit = "'u", .shape = "k x n", .doc = "the window", .settable = false});
  is.state<&MovingAverage::sum>({.unit = "'u", .doc = "sum over the window", .settable = false});
  is.state<&MovingAverage::fresh>(
      {.unit = "'u", .doc = "sum since the circle last closed", .settable = false});
  is.state<&MovingAverage::row>({.doc = "where the next sample goes", .settable = false});
  is.state<&MovingAverage::count>({.doc = "samples seen, up to a full window", .settable = false});
  declare_reset_input(is, "the window");
  is.derived<&MovingAverage::length, &MovingAverage::window>();
}

void MovingAverage::configure(Configure& is) {
  configure_reset_input(*this, is);
  length = whole_periods<&MovingAverage::window>(is, window);
  is.size("k", length);
}

}  // namespace stepwire
