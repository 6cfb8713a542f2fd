#include "blocks/sources/straight_motion.hpp"

#include <fmt/format.h>

#include "blocks/sources/own_time_declare.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire {

void StraightMotion::configure(Configure& is) {
  configure_own_time(*this, is);
  if (rise > 0.0) is.smooth();
  if (!(length() > 0.0))
    is.refuse<&StraightMotion::direction>("has no length; one element must not be 0, e.g. [0, 1]");
  if (from.size() != direction.size())
    is.refuse<&StraightMotion::from>(fmt::format("has {}, and 'direction' {}; give both as many",
                                                 text::counted(from.size(), "element"), direction.size()));
  if (is.connected<&StraightMotion::turn>() && direction.size() != 2)
    is.refuse<&StraightMotion::direction>(fmt::format(
        "has {} elements, but 'turn' is wired, which turns a direction in the plane", direction.size()));
}

void StraightMotion::declare(Declare<StraightMotion>& is) {
  is.block(
      "StraightMotion",
      {.doc = "A motion along a straight line, in any number of dimensions, that starts smoothly and goes "
              "on at constant speed: the speed rises like (1 - cos(pi t / rise)) / 2. Gives position, "
              "velocity and acceleration, e.g. for the pin of a DrivenLinkage.",
       .at_events = true});
  is.parameter<&StraightMotion::from>({.unit = "m", .shape = "d", .doc = "where it starts"});
  is.parameter<&StraightMotion::direction>(
      {.unit = "*", .shape = "d", .doc = "vector along the line, of any length but 0"});
  is.parameter<&StraightMotion::speed>(
      {.unit = "m/s", .doc = "final speed; negative goes against direction"});
  is.parameter<&StraightMotion::rise>(
      {.unit = "s", .doc = "time in which the speed is reached; 0: at once", .at_least = 0.0});
  is.parameter<&StraightMotion::start_>({.unit = "s", .doc = "instant until which it rests"});
  is.input<&StraightMotion::turn>(
      {.unit = "rad",
       .doc = "added to the angle of a direction in the plane; a constant, as the velocity takes it for one",
       .optional = true});
  is.output<&StraightMotion::position>({.unit = "m", .shape = "d", .doc = "position"});
  is.output<&StraightMotion::velocity>({.unit = "m/s", .shape = "d", .doc = "its derivative"});
  is.output<&StraightMotion::acceleration>(
      {.unit = "m/s2", .shape = "d", .doc = "derivative of the velocity"});
  is.output<&StraightMotion::distance>({.unit = "m", .doc = "way from the start, along direction"});
  declare_own_time(is);
  is.prepared<&StraightMotion::unit, &StraightMotion::direction>();
}

}  // namespace stepwire
