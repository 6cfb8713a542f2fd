#include "blocks/continuous/transport_delay.hpp"

#include <fmt/format.h>

#include "engine/model/block/declare.hpp"

namespace stepwire {

void TransportDelay::declare(Declare<TransportDelay>& is) {
  is.block(
      "TransportDelay",
      {.doc =
           "Delay of a continuous signal by any time of a step or more: y(t) = u(t - delay), and `initial` "
           "until then. Between two samples the past is a polynomial through the samples around, of degree 4 "
           "where there are so many. It avoids bends, and ends at jumps, where the block keeps both sides. "
           "For a signal that is sampled take `between: hold`, or Delay. While it is off it keeps what it "
           "saw "
           "last. Samples are as far apart as ticks, also where a solver controls its error: what is faster "
           "than these needs a shorter step. Its output does not depend on its input at the same instant. "
           "Linear analyses take it as exact among continuous blocks, and refuse it beside sampled ones.",
       .source = "A. Harten, B. Engquist, S. Osher, S. R. Chakravarthy 1987, J. Comput. Phys. 71",
       .timing = Timing::continuous,
       .delayed_by = "delay",
       .symbol = {.text = "e^-sT"},
       .at_events = true,
       .at_end = true});
  is.parameter<&TransportDelay::longest>({.unit = "s",
                                          .doc = "highest delay where it is a signal: as much is kept",
                                          .above = 0.0,
                                          .structural = true});
  is.parameter<&TransportDelay::initial>({.unit = "'u", .doc = "output before the first sample arrives"});
  is.parameter<&TransportDelay::between>(
      {.doc = "what the input was between two instants", .words = {"smooth", "linear", "hold"}});
  is.input<&TransportDelay::u>({.unit = "'u", .doc = "signal to delay", .feedthrough = false});
  is.input<&TransportDelay::delay>(
      {.unit = "s",
       .doc = "by how much, a number or a signal: a step at least; beyond `longest` the run ends"});
  is.output<&TransportDelay::y>({.unit = "'u", .doc = "the input, `delay` ago"});
  is.state<&TransportDelay::times>(
      {.unit = "s", .shape = "k", .doc = "times of the samples", .settable = false});
  is.state<&TransportDelay::samples>(
      {.unit = "'u", .shape = "k x n", .doc = "samples on their way", .settable = false});
  is.state<&TransportDelay::left_samples>({.unit = "'u",
                                           .shape = "k x n",
                                           .doc = "the same just before each of these instants",
                                           .settable = false});
  is.state<&TransportDelay::left>(
      {.unit = "'u", .doc = "input just before the present instant", .settable = false});
  is.state<&TransportDelay::left_time>(
      {.unit = "s", .doc = "present instant, or the last one before the block was off", .settable = false});
  is.state<&TransportDelay::edges>({.shape = "k",
                                    .doc = "1 at samples of instants, more at their echoes in a loop, else 0",
                                    .settable = false});
  is.state<&TransportDelay::newest>({.doc = "where the newest sample stands", .settable = false});
  is.state<&TransportDelay::count>({.doc = "how many samples there are", .settable = false});
  is.state<&TransportDelay::newest_edge>(
      {.unit = "s", .doc = "newest sample of an instant", .settable = false});
  is.state<&TransportDelay::passed>(
      {.unit = "s", .doc = "last instant that has arrived, where the delay is a signal", .settable = false});
  is.crossing<&TransportDelay::delay>("an instant arrives, where the delay is a signal", "1");
  is.crossing<&TransportDelay::delay>("it is on its way again, since the delay has grown", "1");
  is.diagnostic<&TransportDelay::out_of_range>(
      {.doc = "the delay is below a step or above `longest`", .ends_run = true});
  is.diagnostic<&TransportDelay::full>(
      {.doc =
           "more than 500 events that bend the input are on their way; take a shorter step or `events: tick`",
       .ends_run = true});
  is.clock<&TransportDelay::t>();
  is.clock<&TransportDelay::period>();
  is.derived<&TransportDelay::rows, From::no_number>();
  is.derived<&TransportDelay::most, From::no_number>();
  is.derived<&TransportDelay::changes, From::no_number>();
  is.derived<&TransportDelay::holds_passed, From::no_number>();
}

void TransportDelay::configure(Configure& is) {
  constexpr double most_rows = 1e7, for_events = 500.0;
  const auto constant = is.constant<&TransportDelay::delay>();
  const double step = is.period();
  changes = !constant;
  holds_passed = changes && is.acts_at_events();
  is.skip_instants(!holds_passed);
  if (constant) is.skip_crossings();
  most = constant ? std::max(*constant, step) : longest;
  const std::string too_short =
      fmt::format("a delay of {} s is less than the step of {} s; take a shorter step, or a Lag of that time",
                  constant.value_or(most), step);
  if (constant && !(*constant >= step * (1.0 - 1e-9))) is.refuse<&TransportDelay::delay>(too_short);
  if (!(most >= step * (1.0 - 1e-9))) is.refuse<&TransportDelay::longest>(too_short);
  if (most / step > most_rows)
    is.refuse<&TransportDelay::longest>(
        fmt::format("{} s are more than {} steps of {} s", most, most_rows, step));
  rows = static_cast<Index>(2.0 * std::ceil(most / step) + for_events);
  is.size("k", rows);
}

}  // namespace stepwire
