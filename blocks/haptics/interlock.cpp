#include "blocks/haptics/interlock.hpp"

#include <fmt/format.h>

#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

std::string first_cause(const Interlock& interlock) {
  const auto number = static_cast<std::size_t>(interlock.first);
  if (interlock.first == Interlock::not_finite) return fmt::format("not a finite number (cause {})", number);
  const std::size_t fault = number - 2;
  return fault < interlock.causes.size() ? fmt::format("{} (cause {})", interlock.causes[fault], number)
                                         : fmt::format("cause {}", number);
}

}  // namespace

void Interlock::configure(Configure& is) {
  const auto count = static_cast<std::size_t>(is.count<&Interlock::faults>());
  if (!causes.empty() && causes.size() != count)
    is.refuse<&Interlock::causes>(fmt::format("{} for {}; each needs one, e.g. [force, speed]",
                                              text::there_are(causes.size(), "name"),
                                              text::counted(count, "fault")));
  if (!is.connected<&Interlock::measured>()) is.size("m", 0);
}

void Interlock::declare(Declare<Interlock>& is) {
  is.block(
      "Interlock",
      {.doc = "Lets the commands u through as long as nothing is wrong, and cuts them off to 0 at the tick "
              "at which one of `faults` becomes true (above 0), or a command or something measured is not a "
              "finite number. What was the first cause stays, in the output `cause` and by its name in a "
              "notice, until a `reset` is pressed while nothing is wrong any more: holding it does not "
              "count. While `dead_man` is not true nothing is let through either, but nothing stays. After a "
              "start, a reset and a press of the dead-man switch the commands come back evenly over the time "
              "`ramp`. With `stop` the run, or the real-time loop, ends with the first cause.",
       .source = "thesis 3.4, safety feature; the ramp, the dead-man switch and all causes but the force are "
                 "additions",
       .at_end = true});
  is.parameter<&Interlock::causes>({.doc = "a name for each of `faults`; their numbers only where left out"});
  is.parameter<&Interlock::ramp>(
      {.unit = "s", .doc = "time in which the commands come back; 0: at once", .at_least = 0.0});
  is.parameter<&Interlock::stop>({.doc = "ends the run with the first cause"});
  is.input<&Interlock::u>({.unit = "'u", .doc = "commands, e.g. currents"});
  is.input<&Interlock::faults>({.unit = "*", .shape = "1", .doc = "what is wrong, where it is true"});
  is.input<&Interlock::measured>(
      {.unit = "*", .shape = "+m", .doc = "what must be finite", .optional = true});
  is.input<&Interlock::dead_man>(
      {.unit = "*", .doc = "true while somebody holds the switch; always where left out", .optional = true});
  is.input<&Interlock::reset>(
      {.unit = "*", .doc = "forgets the cause when it becomes true", .optional = true});
  is.output<&Interlock::y>({.unit = "'u", .doc = "the commands that are let through"});
  is.output<&Interlock::cause>(
      {.doc = "0: nothing is wrong; 1: a number is not finite; from 2 on: of `faults` in their order"});
  is.state<&Interlock::latched>({.doc = "cause at the last tick", .settable = false});
  is.state<&Interlock::first>({.doc = "first cause of the run, also after a reset", .settable = false});
  is.state<&Interlock::share>({.doc = "of the commands that is let through", .settable = false});
  is.state<&Interlock::last_reset>(
      {.doc = "1 where the reset was pressed at the last tick", .settable = false});
  is.diagnostic<&Interlock::tripped, first_cause>({.doc = "the commands are cut off"});
  is.diagnostic<&Interlock::stopped, first_cause>({.doc = "the commands are cut off", .ends_run = true});
  is.clock<&Interlock::period>();
  is.clock<&Interlock::time>();
}

}  // namespace stepwire
