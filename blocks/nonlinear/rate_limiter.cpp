#include "blocks/nonlinear/rate_limiter.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void RateLimiter::declare(Declare<RateLimiter>& is) {
  is.block(
      "RateLimiter",
      {.doc =
           "Follows its input no faster than its rates: y[k] is u[k], held between y[k-1] + falling T and "
           "y[k-1] + rising T, where T is the block's period. It starts at `initial`, whatever the input is. "
           "Between its ticks the output is held. A rate is a number or a signal; a signal of the wrong sign "
           "counts as 0.",
       .symbol = {.curve = "M-1 -.8H-.5L.5 .8H1"}});
  is.parameter<&RateLimiter::rising>({.unit = "'u/s", .doc = "fastest rise", .at_least = 0.0});
  is.parameter<&RateLimiter::falling>(
      {.unit = "'u/s", .doc = "fastest fall, a negative number", .at_most = 0.0});
  is.input<&RateLimiter::u>({.unit = "'u", .doc = "signal to follow"});
  is.input<&RateLimiter::rising_>({.unit = "'u/s", .doc = "fastest rise as a signal", .optional = true});
  is.input<&RateLimiter::falling_>(
      {.unit = "'u/s", .doc = "fastest fall as a signal, negative", .optional = true});
  is.output<&RateLimiter::y>({.unit = "'u", .doc = "the signal with limited rate"});
  is.state<&RateLimiter::last>({.unit = "'u", .doc = "output at the last tick"});
  is.state<&RateLimiter::elapsed>(
      {.unit = "s", .doc = "time since the last tick, 0 at the first", .settable = false});
  declare_reset(is, "'u", "the output");
  is.clock<&RateLimiter::period>();
}

void RateLimiter::configure(Configure& is) {
  configure_reset(*this, is);
}

}  // namespace stepwire
