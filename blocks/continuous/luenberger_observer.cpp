#include "blocks/continuous/luenberger_observer.hpp"

#include "engine/model/block/declare_linear_system.hpp"

namespace stepwire {

void LuenbergerObserver::declare(Declare<LuenbergerObserver>& is) {
  using Block = LuenbergerObserver;
  is.block("LuenbergerObserver",
           {.doc = "Estimates the states of a linear system with a constant gain: dx/dt = A x + B u + L (y - "
                   "C x - D u). Its numbers are SI of what is wired; units are not checked through it.",
            .source = "D. G. Luenberger, IEEE Trans. Automatic Control 16 (1971) 596",
            .discrete = "DiscreteLuenbergerObserver",
            .symbol = {.text = "observer"},
            .smooth = true});
  declare_linear_observer(is);
  is.output<&Block::estimate, &Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "estimated states"});
  declare_reset(is, "*", "the states", "n");
}

void LuenbergerObserver::configure(Configure& is) {
  configure_linear_system(*this, is);
  if (configure_reset(*this, is)) return;
  is.skip_outputs();
  is.skip_update();
}

}  // namespace stepwire
