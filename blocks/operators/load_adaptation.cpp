#include "blocks/operators/load_adaptation.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void LoadAdaptation::declare(Declare<LoadAdaptation>& is) {
  is.block(
      "LoadAdaptation",
      {.doc = "What a hand has learnt of the resistance to its motion, and the force by which it makes up "
              "for it, along the motion that it feels. Two states, a fast and a slow one, are drawn by what "
              "is felt less what is known, while the hand moves, and forget at all times: with the default "
              "rates 0.74 of a lasting load are carried. A hand at rest adds nothing, and nothing of a "
              "position is integrated. What is no longer felt is lost within a reflex: the force is never "
              "more than `most` of what was felt just now. `initial_fast` and `initial_slow` are what the "
              "trials before have left.",
       .source = "two states: Smith, Ghazizadeh and Shadmehr 2006, PLoS Biol 4:e179; learnt apart for the "
                 "velocity, along the motion: Kurtzer, DiZio and Lackner 2005, Exp Brain Res 164:120; lost "
                 "within 500 ms: Crevecoeur, Thonnard and Lefevre, 10.1101/269134",
       .timing = Timing::discrete});
  is.parameter<&LoadAdaptation::fast_time>(
      {.unit = "s", .doc = "in which the fast state forgets", .above = 0.0});
  is.parameter<&LoadAdaptation::fast_rate>({.unit = "1/s", .doc = "at which it learns", .at_least = 0.0});
  is.parameter<&LoadAdaptation::slow_time>(
      {.unit = "s", .doc = "in which the slow state forgets", .above = 0.0});
  is.parameter<&LoadAdaptation::slow_rate>({.unit = "1/s", .doc = "at which it learns", .at_least = 0.0});
  is.parameter<&LoadAdaptation::smoothing>(
      {.unit = "m/s", .doc = "speed below which the force fades, with the direction", .above = 0.0});
  is.parameter<&LoadAdaptation::strength>({.unit = "N", .doc = "the most that is added", .at_least = 0.0});
  is.parameter<&LoadAdaptation::most>({.doc = "of what is felt, the share that is added at most; below 1 a "
                                              "friction is never driven",
                                       .at_least = 0.0,
                                       .at_most = 1.0});
  is.parameter<&LoadAdaptation::reflex>(
      {.unit = "s", .doc = "time in which what is no longer felt is lost", .above = 0.0});
  is.parameter<&LoadAdaptation::onset>(
      {.unit = "s", .doc = "in which the force follows the motion", .above = 0.0});
  is.input<&LoadAdaptation::force>({.unit = "N", .doc = "of the hand on what it moves, as it is felt"});
  is.input<&LoadAdaptation::velocity>({.unit = "m/s", .doc = "of the hand, as it is felt"});
  is.output<&LoadAdaptation::y>({.unit = "N", .doc = "the force that is added"});
  is.output<&LoadAdaptation::learned>({.unit = "N", .doc = "the resistance that is known, fast + slow"});
  is.output<&LoadAdaptation::felt>({.unit = "N", .doc = "the resistance that is felt, along the motion"});
  is.state<&LoadAdaptation::push>({.unit = "N", .doc = "the force at the last tick", .settable = false});
  is.state<&LoadAdaptation::fast>({.unit = "N", .doc = "what is learnt in a second"});
  is.state<&LoadAdaptation::slow>({.unit = "N", .doc = "what is learnt in a minute"});
  is.state<&LoadAdaptation::held>({.unit = "N", .doc = "what was felt just now", .settable = false});
  is.clock<&LoadAdaptation::period>();
}

}  // namespace stepwire
