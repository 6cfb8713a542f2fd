// What becomes of a step in which outputs depend on themselves, or something crosses a threshold.
#include "engine/model/diagram/head_solving.hpp"

namespace stepwire::diagram {

using yaml::form;

namespace {

using HeadRow = yaml::KeyRow<Diagram, HeadReading>;
using LoopsTable = yaml::KeyTable<AlgebraicLoops, HeadReading>;

const LoopsTable& loops_table() {
  static const LoopsTable table(
      "algebraic loops", "{tolerance: 1e-12, max_iterations: 50}",
      {{"tolerance",
        "largest correction of a signal, in sizes of it, with which a loop counts as solved where rounding "
        "allows no better",
        form::above_zero(form::number()), &AlgebraicLoops::tolerance},
       {"max_iterations",
        "passes through a loop's blocks at one instant, beyond which the run ends; in a real-time loop it "
        "goes "
        "on, and the tick is reported",
        form::whole(2), &AlgebraicLoops::max_iterations}});
  return table;
}

/// The form of `algebraic_loops`: a word, or how they are solved.
const yaml::Key& loops_form() {
  static const yaml::Key words =
      form::words({{"refuse", "an error that names every block of the loop"},
                   {"solve", "solved at every tick, and at every stage of the solver"}});
  static const yaml::Key form = form::either({words, loops_table().form});
  return form;
}

void read_loops(Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
  if (node.is_scalar()) return read.take(node, loops_form().of.front(), diagram.algebraic_loops.solve);
  diagram.algebraic_loops.solve = loops_table().read(node, diagram.algebraic_loops, read);
}

using EventsTable = yaml::KeyTable<Events, HeadReading>;

const EventsTable& events_table() {
  static const EventsTable table("events", "{max_per_step: 20}",
                                 {{"max_per_step", "events in one step beyond which the run ends",
                                   form::whole(1), &Events::max_per_step}});
  return table;
}

/// The form of `events`: a word, or how they are located.
const yaml::Key& events_form() {
  static const yaml::Key words =
      form::words({{"tick", "what crosses a threshold is found at the next tick"},
                   {"locate", "steps are split where something crosses, to 1e-12 of the step"}});
  static const yaml::Key form = form::either({words, events_table().form});
  return form;
}

void read_events(Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
  if (node.is_scalar()) return read.take(node, events_form().of.front(), diagram.events.locate);
  diagram.events.locate = events_table().read(node, diagram.events, read);
}

}  // namespace

HeadRow loops_row() {
  return yaml::otherwise(
      "refuse", HeadRow{"algebraic_loops",
                        "what becomes of outputs that depend on themselves at the same instant: solve, "
                        "or how: {tolerance: 1e-12}",
                        loops_form(), read_loops});
}

HeadRow events_row() {
  return yaml::otherwise("tick",
                         HeadRow{"events",
                                 "what becomes of limits, switches and edges between two ticks: locate, or "
                                 "how: {max_per_step: 20}",
                                 events_form(), read_events});
}

}  // namespace stepwire::diagram
