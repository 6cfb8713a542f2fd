#include "blocks/discrete/discrete_luenberger_observer.hpp"

#include "engine/model/block/declare_linear_system.hpp"

namespace stepwire {

void DiscreteLuenbergerObserver::declare(Declare<DiscreteLuenbergerObserver>& is) {
  using Block = DiscreteLuenbergerObserver;
  is.block("DiscreteLuenbergerObserver",
           {.doc = "Estimates the states of a linear system at its ticks, with a constant gain: x[k+1] = A x "
                   "+ B u + L (y - C x - D u). Its output is x[k], which does not contain the measurement of "
                   "this tick. Its numbers are SI of what is wired; units are not checked through it.",
            .source = "D. G. Luenberger, IEEE Trans. Automatic Control 16 (1971) 596",
            .symbol = {.text = "observer"}});
  declare_linear_observer(is);
  is.output<&Block::estimate>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::next>({.unit = "*", .shape = "n", .doc = "states of the next tick", .settable = false});
  is.state<&Block::residual>(
      {.unit = "*", .shape = "p", .doc = "measurement less what was expected of it", .settable = false});
  declare_reset(is, "*", "the states", "n");
}

void DiscreteLuenbergerObserver::configure(Configure& is) {
  configure_linear_system(*this, is);
  configure_reset(*this, is);
}

}  // namespace stepwire
