#include "blocks/plants/friction.hpp"

#include "engine/model/block/declare.hpp"

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
  is.parameter<&Friction::mass>(
      {.unit = "kg", .doc = "of the body, as in Mass", .above = 0.0, .required = true});
  is.parameter<&Friction::coulomb>(
      {.unit = "N", .doc = "friction of a motion", .at_least = 0.0, .required = true});
  is.parameter<&Friction::breakaway>(
      {.unit = "N",
       .doc = "what it takes to move a body at rest; `coulomb` where that is more",
       .at_least = 0.0});
  is.parameter<&Friction::viscous>(
      {.unit = "N s/m", .doc = "friction that grows with the speed", .at_least = 0.0});
  is.parameter<&Friction::stribeck>(
      {.unit = "m/s",
       .doc = "speed at which all but 1/e of the difference to `breakaway` is gone; 0: at once",
       .at_least = 0.0});
  is.input<&Friction::force>({.unit = "N", .doc = "sum of all other forces on the body"});
  is.input<&Friction::velocity>({.unit = "m/s", .doc = "of the body"});
  is.crossing<&Friction::velocity>("the body comes to rest");
  is.crossing<&Friction::force>("the other forces exceed what holds it");
  is.output<&Friction::y>({.unit = "N", .doc = "force of the friction on the body"});
  is.output<&Friction::slides>({.doc = "1 and -1 while it slides that way, 0 while it sticks"});
  is.state<&Friction::way>({.doc = "the same, as it was at the last instant", .settable = false});
  is.state<&Friction::rest>({.unit = "m/s", .doc = "velocity at the last instant", .settable = false});
  is.clock<&Friction::period>();
}

}  // namespace stepwire
