#include "blocks/operators/resistance_search.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void ResistanceSearch::declare(Declare<ResistanceSearch>& is) {
  is.block(
      "ResistanceSearch",
      {.doc = "How a hand finds back to an authorized region by what it feels alone, where resistance is "
              "F_max sin(angle between its push and the shortest way), the law D2 of Directionality: since "
              "resistance always opposes the motion, its direction tells nothing, and its strength not to "
              "which side the way lies. At each tick the hand turns by asin(F / F_max), in the sense of the "
              "last time, or in the other one where the resistance has grown since; at first toward "
              "`guess`. It does not turn where it feels no more than in a free motion. While it does not "
              "move, or nothing resists by intent (maximum 0), what was found last is kept; its precision "
              "is 0 before the first time.",
       .source = "thesis 3.4.2, eq. 14-16; Weber fraction of force: Pang, Tan and Durlach 1991",
       .timing = Timing::discrete});
  is.parameter<&ResistanceSearch::weber>(
      {.doc = "error of a felt force as a share of it, standard deviation", .at_least = 0.0});
  is.input<&ResistanceSearch::resistance>({.unit = "N", .doc = "strength of the force that is felt, F"});
  is.input<&ResistanceSearch::free>(
      {.unit = "N", .doc = "resistance that a free motion meets, as learnt before"});
  is.input<&ResistanceSearch::maximum>(
      {.unit = "N", .doc = "resistance straight across the way, F_max, as learnt before"});
  is.input<&ResistanceSearch::push>({.unit = "rad", .doc = "direction in which the hand pushes"});
  is.input<&ResistanceSearch::guess>(
      {.unit = "rad", .doc = "where else the way is believed to lie: tells the first sense"});
  is.input<&ResistanceSearch::moving>({.doc = "true while the hand moves"});
  is.output<&ResistanceSearch::heading>({.unit = "rad", .doc = "where the way lies by what is felt"});
  is.output<&ResistanceSearch::precision>(
      {.unit = "1/rad^2", .doc = "one over the variance of that; 0: nothing was felt yet"});
  is.output<&ResistanceSearch::sense>({.doc = "1: turned to the left, -1: to the right, 0: not yet"});
  is.state<&ResistanceSearch::felt>({.unit = "N", .doc = "resistance of the last time", .settable = false});
  is.state<&ResistanceSearch::turning>({.doc = "sense of the last time", .settable = false});
  is.state<&ResistanceSearch::found>({.unit = "rad", .doc = "heading of the last time", .settable = false});
  is.state<&ResistanceSearch::certain>({.unit = "1/rad^2", .doc = "its precision", .settable = false});
}

}  // namespace stepwire
