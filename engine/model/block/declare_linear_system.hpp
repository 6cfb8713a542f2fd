#pragma once

#include <algorithm>

#include "engine/model/block/declare_reset.hpp"
#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Declares the matrices of a LinearSystem. An input that is optional needs B only where it is connected.
template <class Block>
void declare_linear_system(Declare<Block>& is, bool optional_input) {
  const char* const input_matrix = optional_input ? "input matrix; needed where u is wired" : "input matrix";
  is.template parameter<&Block::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.template parameter<&Block::B>(
      {.unit = "*", .shape = "n x m", .doc = input_matrix, .required = !optional_input});
  is.template parameter<&Block::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.template parameter<&Block::D>(
      {.unit = "*", .shape = "p x m", .doc = "what passes straight through; zero where left out"});
  is.template derived<&Block::direct, &Block::D>();
}

/// Declares a LinearObserver, without its states and its output.
template <class Block>
void declare_linear_observer(Declare<Block>& is) {
  declare_linear_system(is, true);
  is.template parameter<&Block::L>(
      {.unit = "*", .shape = "n x p", .doc = "gain of the observer", .required = true});
  is.template input<&Block::measured>(
      {.unit = "*", .shape = "p", .doc = "the measurement y", .feedthrough = false});
  is.template input<&Block::u>(
      {.unit = "*", .shape = "m", .doc = "known inputs", .feedthrough = false, .optional = true});
}

/// Determines `direct`, and refuses an input without B.
template <class Block>
void configure_linear_system(Block& block, Configure& is) {
  const bool has_input = is.connected<&Block::u>();
  if (has_input && block.B.elements().empty()) is.refuse<&Block::B>("it is needed, since u is wired");
  block.direct = has_input && std::ranges::any_of(block.D.elements(), [](double d) { return d != 0.0; });
}

}  // namespace stepwire
