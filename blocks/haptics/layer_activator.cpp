#include "blocks/haptics/layer_activator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "blocks/haptics/layer_reader.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void LayerActivator::configure(Configure& is) {
  const Index layers = is.count<&LayerActivator::u>();
  if (initial > layers)
    is.refuse<&LayerActivator::initial>(fmt::format("there is no layer {}; there are {}", initial, layers));
  const LayerReader reader(layers, is.count<&LayerActivator::regions>(),
                           [&](const std::string& message, const Value& where) {
                             is.refuse<&LayerActivator::switches>(message, where);
                           });
  const LayerSwitches read = reader.read(switches.value());
  ways = Numbers(read.ways);
  events = Numbers(read.events);
  is.feedthrough<&LayerActivator::u, &LayerActivator::weights>(false);
  is.feedthrough<&LayerActivator::u, &LayerActivator::layer>(false);
  is.feedthrough<&LayerActivator::u, &LayerActivator::switched>(false);
  is.size("k", layers);
  is.size("r", std::max<Index>(1, is.count<&LayerActivator::regions>()));
  is.size("s", ways.size() / way_size);
}

void LayerActivator::declare(Declare<LayerActivator>& is) {
  is.block(
      "LayerActivator",
      {.doc =
           "Switches between the layers of a dynamic resistance map, of which one is active. `switches` is a "
           "list of {from, to, when}: two layers, numbered from 1 as in u, and an event, or a list of events "
           "that must happen one after the other while the first layer is active. Events: {pass: POINT, "
           "within: RADIUS}, the way since the last tick comes that near; {cross: [POINT, POINT], toward: "
           "left} (or right), it crosses the line between the points to that side; {enter: K} and {leave: "
           "K}, the K-th of `regions` (signed distances, positive outside) turns negative or positive; "
           "{after: TIME} since the layer became active or the event before. Of several switches at one "
           "tick the first counts, and its effect begins at the next. Over the time `blend` the new layer "
           "takes the place of the old one evenly, so that a switch moves y from tick to tick by at most "
           "period/blend times the largest difference of two layers; with blend 0 at once.",
       .source = "thesis 3.1.1 and 3.4, figure 25; blending and the order of events are assumptions"});
  is.parameter<&LayerActivator::switches>({.doc = "when which layer gives way to which", .required = true});
  is.parameter<&LayerActivator::blend>(
      {.unit = "s", .doc = "time in which a switch is completed", .at_least = 0.0});
  is.parameter<&LayerActivator::initial>({.doc = "layer that is active first", .at_least = 1.0});
  is.input<&LayerActivator::u>({.unit = "'u", .doc = "what each layer gives, e.g. its wanted force"});
  is.input<&LayerActivator::position>(
      {.unit = "m", .shape = "2", .doc = "measured position of the end-effector", .feedthrough = false});
  is.input<&LayerActivator::regions>({.unit = "m",
                                      .shape = "1",
                                      .doc = "signed distances from regions",
                                      .feedthrough = false,
                                      .optional = true});
  is.output<&LayerActivator::y>({.unit = "'u", .doc = "what the active layer gives, blended after a switch"});
  is.output<&LayerActivator::weights>({.shape = "k", .doc = "share of each layer in y; their sum is 1"});
  is.output<&LayerActivator::layer>({.doc = "number of the active layer, from 1"});
  is.output<&LayerActivator::switched>({.doc = "how many switches there were"});
  is.state<&LayerActivator::mixed>({.shape = "k", .doc = "weights at the last switch", .settable = false});
  is.state<&LayerActivator::active>({.doc = "index of the active layer, from 0", .settable = false});
  is.state<&LayerActivator::share>({.doc = "how far the last switch has come, 0 to 1", .settable = false});
  is.state<&LayerActivator::count>({.doc = "switches so far", .settable = false});
  is.state<&LayerActivator::reached>(
      {.shape = "s", .doc = "for each switch, how many of its events have happened", .settable = false});
  is.state<&LayerActivator::waited>({.shape = "s", .doc = "ticks since the last of them", .settable = false});
  is.state<&LayerActivator::last_position>(
      {.unit = "m", .shape = "2", .doc = "position at the last tick", .settable = false});
  is.state<&LayerActivator::last_distances>(
      {.unit = "m", .shape = "r", .doc = "distances from the regions then", .settable = false});
  is.state<&LayerActivator::begun>({.doc = "1 from the first tick on", .settable = false});
  is.clock<&LayerActivator::period>();
  is.derived<&LayerActivator::ways, From::no_number>();
  is.derived<&LayerActivator::events, From::no_number>();
}

}  // namespace stepwire
