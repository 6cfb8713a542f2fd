#pragma once

#include "blocks/sources/own_time.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

/// Declares the members of OwnTime. The options of the block must have `.at_events = true`.
template <class Block>
void declare_own_time(Declare<Block>& is) {
  is.template parameter<&Block::restart>(
      {.doc =
           "begin anew where a condition with `states: reset` makes the block active: its time is 0 there; "
           "false: its time is that of the run"});
  is.template clock<&Block::t>();
  is.template state<&Block::begun>({.doc = "0 before the first instant, then 1", .settable = false});
  is.template state<&Block::origin>(
      {.unit = "s", .doc = "time of the run at which it began, with `restart`", .settable = false});
}

/// Configures a source: with the time of the run it has no states. FromFile has its own update().
template <class Block>
void configure_own_time(const Block& block, Configure& is, bool has_update = false) {
  if (block.restart) return;
  if (!has_update) is.skip_update();
  is.remember_nothing();
  is.keep_to_ticks();
}

}  // namespace stepwire
