#include "blocks/logic/counter.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Counter::declare(Declare<Counter>& is) {
  is.block(
      "Counter",
      {.doc = "Counts from `initial` on where its input becomes true (or as `count_at` says), shown at the "
              "same tick; without an input it counts its ticks, the first one aside. A count beyond `upper` "
              "or `lower` is held there, or goes on at the other end (wrap): {lower: 0, upper: 9, beyond: "
              "wrap} has ten values. While `down` is true it counts downwards.",
       .symbol = {.curve = "M-1 -.8H-.5V-.3H0V.2H.5V.7H1"},
       .at_events = true});
  is.parameter<&Counter::count_at>(
      {.doc =
           "what counts: the input becomes true (rising), false (falling), either, or each tick at which it "
           "is true (level). True is above 0; there is no edge at the first step",
       .words = {"rising", "falling", "either", "level"}});
  is.parameter<&Counter::step>({.doc = "added each time"});
  is.parameter<&Counter::lower>({.doc = "lowest count; none where left out"});
  is.parameter<&Counter::upper>({.doc = "highest count; none where left out"});
  is.parameter<&Counter::beyond>(
      {.doc = "what becomes of a count beyond a limit", .words = {"hold", "wrap"}});
  is.input<&Counter::u>(
      {.unit = "*", .doc = "what is counted; ticks where nothing is wired", .optional = true});
  is.input<&Counter::down>({.unit = "*", .doc = "above 0: counts downwards", .optional = true});
  is.crossing_of<&Counter::reset>("the reset signal becomes true or false");
  is.crossing_of<&Counter::u>("u becomes true or false");
  is.output<&Counter::y>({.doc = "the count, this tick's included"});
  is.state<&Counter::count>({.doc = "the count so far"});
  is.state<&Counter::last>(
      {.doc = "input at the last tick: -1 false, 1 true, 0 none yet", .settable = false});
  declare_reset(is, "1", "the count", "1");
}

void Counter::configure(Configure& is) {
  configure_reset(*this, is);
  if (!is.connected<&Counter::u>() || count_at == Trigger::level) {
    is.keep_to_ticks();
    is.skip_crossings();
  }
  if (lower > upper) is.refuse<&Counter::lower>("lies above `upper`");
  if (beyond == Beyond::wrap && !(lower > -unlimited && upper < unlimited))
    is.refuse<&Counter::beyond>("'wrap' needs both `lower` and `upper`");
}

}  // namespace stepwire
