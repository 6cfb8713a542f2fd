#include "blocks/plants/friction.hpp"

#include "blocks/plants/dry_friction_declare.hpp"

namespace stepwire {

void Friction::declare(Declare<Friction>& is) {
  is.block("Friction",
           {.doc = "Dry friction on a mass, which sticks. At rest it balances the other forces as long as "
                   "they stay within "
                   "`breakaway`; in motion it is `coulomb`, more at low speed where `stribeck` is given "
                   "(breakaway at 0), and "
                   "`viscous` times the speed, against the motion. Whether it sticks, and which way it "
                   "slides, is decided at "
                   "ticks, and at the instants themselves with `events: locate`; a velocity that is left as "
                   "it begins to stick is "
                   "taken away within one step. Wire the sum of all other forces to `force`, and that sum "
                   "and `y` to the mass. "
                   "For friction without sticking see Coulomb.",
            .source =
                "B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit 1994, Automatica 30(7); D. Karnopp 1985",
            .timing = Timing::continuous,
            .symbol = {.curve = "M-1 .7H0V-.7H1"}});
  declare_dry_friction(is);
  is.crossing<&Friction::velocity>("the body comes to rest");
  is.crossing<&Friction::force>("the other forces exceed what holds it");
}

}  // namespace stepwire
