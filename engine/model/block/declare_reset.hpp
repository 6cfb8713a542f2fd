#pragma once

#include <string>

#include "engine/model/block/declare.hpp"
#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Declares the members of ResetInput, after the states of the block. `what` names the reset quantity: "the
/// integral". A reset of continuous states is a located event.
template <class Block>
void declare_reset_input(Declare<Block>& is, const std::string& what = "the states") {
  is.template parameter<&Block::trigger>(
      {.doc = "what of the reset signal resets: it becomes true (rising), false (falling), either, or it is "
              "true (level: held until it is false again). True is above 0; there is no edge at the first "
              "step",
       .words = {"rising", "falling", "either", "level"}});
  is.template input<&Block::reset>(
      {.unit = "*",
       .doc = "puts " + what + " back as at the start, in this tick's output, too",
       .optional = true});
  is.template state<&Block::side>(
      {.doc = "last reset signal: -1 false, 1 true, 0 none yet", .settable = false});
  is.template derived<&Block::resets, From::no_number>();
  if (is.has_continuous_state())
    is.template crossing_of<&Block::reset>("the reset signal becomes true or false");
}

/// Declares the members of Resettable, with the unit and shape of the reset state.
template <class Block>
void declare_reset(Declare<Block>& is, const std::string& unit, const std::string& what = "the state",
                   const std::string& shape = "n") {
  declare_reset_input(is, what);
  is.template input<&Block::value>({.unit = unit,
                                    .shape = shape,
                                    .doc = "what a reset goes to; `initial` where nothing is wired",
                                    .optional = true});
  is.template input<&Block::initial_>(
      {.unit = unit,
       .shape = shape,
       .doc = "`initial` as a signal: read at the first step, and at a reset without `value`",
       .optional = true});
  is.template state<&Block::home>({.unit = unit, .shape = shape, .doc = "initial value", .settable = false});
}

/// Determines in configure() whether a reset is connected. Without one, start() and update() can be skipped.
template <class Block>
bool configure_reset_input(Block& block, Configure& is) {
  block.resets = is.connected<&Block::reset>();
  return block.resets;
}

template <class Block>
bool configure_reset(Block& block, Configure& is) {
  if (!is.connected<&Block::reset>() && is.connected<&Block::value>())
    is.require<&Block::reset>("a value to reset to is wired");
  block.resets = is.connected<&Block::reset>() || is.connected<&Block::initial_>();
  is.skip_instants(!block.resets);
  is.skip_before_instant(block.trigger != ResetInput::Trigger::level || !is.connected<&Block::reset>() ||
                         !(is.connected<&Block::value>() || is.connected<&Block::initial_>()));
  return block.resets;
}

}  // namespace stepwire
