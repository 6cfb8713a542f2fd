#include "blocks/discrete/discrete_luenberger_observer.hpp"

#include <algorithm>

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void DiscreteLuenbergerObserver::declare(Declare<DiscreteLuenbergerObserver>& is) {
  using Block = DiscreteLuenbergerObserver;
  is.block("DiscreteLuenbergerObserver",
           {.doc = "Estimates the states of a linear system at its ticks, with a constant gain: x[k+1] = A x "
                   "+ B u + L (y - C x - D u). Its output is x[k], which does not contain the measurement of "
                   "this tick. Its numbers are SI of what is wired; units are not checked through it.",
            .source = "D. G. Luenberger, IEEE Trans. Automatic Control 16 (1971) 596",
            .symbol = {.text = "observer"}});
  is.parameter<&Block::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.parameter<&Block::B>({.unit = "*", .shape = "n x m", .doc = "input matrix; needed where u is wired"});
  is.parameter<&Block::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.parameter<&Block::D>(
      {.unit = "*", .shape = "p x m", .doc = "what passes straight through; zero where left out"});
  is.parameter<&Block::L>({.unit = "*", .shape = "n x p", .doc = "gain of the observer", .required = true});
  is.input<&Block::measured>({.unit = "*", .shape = "p", .doc = "the measurement y", .feedthrough = false});
  is.input<&Block::u>(
      {.unit = "*", .shape = "m", .doc = "known inputs", .feedthrough = false, .optional = true});
  is.output<&Block::estimate>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::next>({.unit = "*", .shape = "n", .doc = "states of the next tick", .settable = false});
  is.state<&Block::residual>(
      {.unit = "*", .shape = "p", .doc = "measurement less what was expected of it", .settable = false});
  declare_reset(is, "*", "the states", "n");
  is.derived<&Block::direct, &Block::D>();
}

void DiscreteLuenbergerObserver::configure(Configure& is) {
  if (is.connected<&DiscreteLuenbergerObserver::u>() && B.elements().empty())
    is.refuse<&DiscreteLuenbergerObserver::B>("it is needed, since u is wired");
  direct = is.connected<&DiscreteLuenbergerObserver::u>() &&
           std::any_of(D.elements().begin(), D.elements().end(), [](double d) { return d != 0.0; });
  configure_reset(*this, is);
}

}  // namespace stepwire
