#include "blocks/cosimulation/fmu.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

template <class Block>
std::string reason(const Block& block) {
  return block.reason();
}

template <class Block>
void declare_parameters(Declare<Block>& is) {
  is.block(
      "Fmu",
      {.doc = "A unit of FMI 2 or 3 (a file .fmu that another program has exported). Its inputs and outputs "
              "that are "
              "numbers are the ports of the block, with '_' in the place of what no name here has: "
              "`body.v[1]` is "
              "body_v_1. An input that is not fed keeps the unit's start value. Numbers are SI by the "
              "factors of "
              "the unit's own units. With co-simulation the unit goes from tick to tick, `every` of the "
              "block or "
              "the step, and its outputs are those after its last step; with model exchange our solver "
              "integrates "
              "its states, and its events are found as those of other blocks are: where `events: locate` "
              "stands at their instant, else at the ticks. A fault of the unit ends the run with its "
              "message. A unit that terminates the simulation ends the run with its last "
              "values, as `stop_when` does. The "
              "unit is foreign code: it runs in a process of its own, and a crash, an exit or a call that "
              "does not "
              "return is a fault of the block. With `isolate: false` it runs in the program, which costs "
              "less a step "
              "and ends where the unit ends it. Runs with it are interpreted.",
       .source = "Modelica Association, Functional Mock-up Interface 3.0 (2022) and 2.0",
       .not_real_time = "calls foreign code, of whose steps nothing bounds the time",
       .symbol = {.text = "{file|unit}"}});
  is.template parameter<&Block::file>(
      {.doc = "path of a .fmu file, beside the diagram or data/...", .required = true, .structural = true});
  is.template parameter<&Block::interface>(
      {.doc = "which interface of the unit is used; automatic: co-simulation where it has both",
       .words = {"automatic", "co_simulation", "model_exchange"},
       .structural = true});
  is.template parameter<&Block::parameters>(
      {.doc =
           "values of the unit's parameters, and start values of its variables, by their names: {k: 2 1/s}; "
           "a bare number is SI"});
  is.template parameter<&Block::isolate>({.doc = "run it in a process of its own", .structural = true});
  is.template state<&Block::unit_state>(
      {.unit = "*", .shape = "k", .doc = "the unit's own state, as bytes", .settable = false});
  is.template state<&Block::unit_moves>({.doc = "how often it has moved on", .settable = false});
  is.template diagnostic<&Block::unit_failed, &reason<Block>>(
      {.doc = "the unit has failed", .ends_run = true});
  is.template diagnostic<&Block::unit_over>(
      {.doc = "the unit has ended the run", .ends_run = true, .is_fault = false});
  is.template clock<&Block::t>();
}

}  // namespace

void SteppedFmu::declare(Declare<SteppedFmu>& is) {
  declare_parameters(is);
  is.state<&SteppedFmu::unit_outputs>(
      {.unit = "*", .shape = "h", .doc = "its outputs after the last step", .settable = false});
  is.diagnostic<&SteppedFmu::beyond_step>(
      {.doc =
           "the unit passes the ends of steps by a part of its own step, so that its outputs are later than "
           "their rows; model exchange, or a period of whole internal steps, has none of this"});
  is.clock<&SteppedFmu::period>();
}

void ContinuousFmu::declare(Declare<ContinuousFmu>& is) {
  declare_parameters(is);
  is.state<&ContinuousFmu::unit_states>(
      {.unit = "*", .shape = "x", .doc = "its continuous states", .settable = false});
  is.state<&ContinuousFmu::unit_event>({.unit = "s", .doc = "time of its next event", .settable = false});
}

}  // namespace stepwire
