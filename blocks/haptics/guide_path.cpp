#include "blocks/haptics/guide_path.hpp"

#include <fmt/core.h>

#include "engine/model/block/declare.hpp"

namespace stepwire {

void GuidePath::configure(Configure& is) {
  if (renewal == Renewal::every_sample && !(trail > half_width))
    is.refuse<&GuidePath::trail>(
        fmt::format("{} m is not above the half width of {} m, so that no motion would leave the path", trail,
                    half_width));
}

void GuidePath::declare(Declare<GuidePath>& is) {
  is.block("GuidePath",
           {.doc = "Guide path back to an authorized region: error stands in place of the distance from the "
                   "region, eased within half_width of the straight path to the nearest boundary point, and "
                   "growing steeply beside it. Without renewal the path is laid where the pin is first found "
                   "outside, and stays until the region is reached. With renewal at every sample it leads to "
                   "the boundary point that is nearest now, and its start follows the pin like a trailing "
                   "load, so that wherever the pin is pushed there is a path back. Inside, error is 0.",
            .source = "thesis 2.4.3; the trailing start is an assumption"});
  is.parameter<&GuidePath::renewal>(
      {.doc = "whether the path is laid anew", .words = {"none", "every_sample"}});
  is.parameter<&GuidePath::half_width>(
      {.unit = "m", .doc = "half the width in which the resistance is eased", .above = 0.0});
  is.parameter<&GuidePath::steepness>(
      {.doc = "growth of the error per distance beside the path", .above = 0.0});
  is.parameter<&GuidePath::easing>(
      {.doc = "share of the resistance that the path takes away", .at_least = 0.0, .at_most = 1.0});
  is.parameter<&GuidePath::trail>(
      {.unit = "m", .doc = "how far behind the pin the start of a renewed path is at most", .above = 0.0});
  is.input<&GuidePath::position>({.unit = "m", .doc = "of the pin"});
  is.input<&GuidePath::nearest>({.unit = "m", .doc = "nearest boundary point, from a Region"});
  is.input<&GuidePath::distance>(
      {.unit = "m", .doc = "signed distance from the region, from the same Region"});
  is.output<&GuidePath::error>({.unit = "m", .doc = "eased distance from the region, never negative"});
  is.output<&GuidePath::beside>({.unit = "m", .doc = "distance from the path beyond its half width"});
  is.output<&GuidePath::start>({.unit = "m", .doc = "where the path starts; the pin's position inside"});
  is.output<&GuidePath::target>({.unit = "m", .doc = "where it ends, on the boundary"});
  is.state<&GuidePath::from>({.unit = "m", .doc = "start of the path", .settable = false});
  is.state<&GuidePath::to>({.unit = "m", .doc = "its end", .settable = false});
  is.state<&GuidePath::laid>({.doc = "1 while there is a path", .settable = false});
}

}  // namespace stepwire
