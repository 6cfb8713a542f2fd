#include "blocks/continuous/luenberger_observer.hpp"

#include <algorithm>

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void LuenbergerObserver::declare(Declare<LuenbergerObserver>& is) {
  using Block = LuenbergerObserver;
  is.block("LuenbergerObserver",
           {.doc = "Estimates the states of a linear system with a constant gain: dx/dt = A x + B u + L (y - "
                   "C x - D u). Its numbers are SI of what is wired; units are not checked through it.",
            .source = "D. G. Luenberger, IEEE Trans. Automatic Control 16 (1971) 596",
            .symbol = {.text = "observer"},
            .smooth = true});
  is.parameter<&Block::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.parameter<&Block::B>({.unit = "*", .shape = "n x m", .doc = "input matrix; needed where u is wired"});
  is.parameter<&Block::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.parameter<&Block::D>(
      {.unit = "*", .shape = "p x m", .doc = "what passes straight through; zero where left out"});
  is.parameter<&Block::L>({.unit = "*", .shape = "n x p", .doc = "gain of the observer", .required = true});
  is.input<&Block::measured>({.unit = "*", .shape = "p", .doc = "the measurement y", .feedthrough = false});
  is.input<&Block::u>(
      {.unit = "*", .shape = "m", .doc = "known inputs", .feedthrough = false, .optional = true});
  is.output<&Block::estimate, &Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  declare_reset(is, "*", "the states", "n");
  is.derived<&Block::direct, &Block::D>();
}

void LuenbergerObserver::configure(Configure& is) {
  if (is.connected<&LuenbergerObserver::u>() && B.elements().empty())
    is.refuse<&LuenbergerObserver::B>("it is needed, since u is wired");
  direct = is.connected<&LuenbergerObserver::u>() &&
           std::any_of(D.elements().begin(), D.elements().end(), [](double d) { return d != 0.0; });
  if (configure_reset(*this, is)) return;
  is.skip_outputs();
  is.skip_update();
}

}  // namespace stepwire
