#include "blocks/plants/karnopp.hpp"

#include "blocks/plants/dry_friction_declare.hpp"

namespace stepwire {

void Karnopp::declare(Declare<Karnopp>& is) {
  is.block("Karnopp",
           {.doc = "Dry friction with a band of velocity in which a body counts as at rest, Karnopp's model. "
                   "Within the band the friction balances the other forces up to `breakaway`, and takes the "
                   "velocity that is left within one step; outside it is `coulomb`, more at low speed where "
                   "`stribeck` is given, and `viscous` times the speed, against the motion. A body that "
                   "breaks away has `breakaway` against it until it leaves the band. The choice is made at "
                   "ticks, and at the instants themselves with `events: locate`. The error is of the order "
                   "of the band. Friction sticks without a band. Wire the sum of all other forces to "
                   "`force`, and that sum and `y` to the mass.",
            .source = "D. Karnopp 1985, ASME J. Dyn. Sys. Meas. Control 107(1), 100-103",
            .timing = Timing::continuous,
            .symbol = {.curve = "M-1 .7H-.15V.5M-.15 0H.15M.15 -.5V-.7H1"}});
  is.parameter<&Karnopp::band>(
      {.unit = "m/s",
       .doc = "speed below which the body counts as at rest; well below the speeds of interest",
       .above = 0.0});
  declare_dry_friction(is);
  is.output<&Karnopp::pseudo>(
      {.unit = "m/s", .doc = "velocity as the model has it: 0 within the band, else that of the body"});
  is.crossing<&Karnopp::velocity>("the body enters or leaves the band");
  is.crossing<&Karnopp::force>("the other forces exceed what holds it");
}

}  // namespace stepwire
