// Treatment of algebraic loops and of threshold crossings in a step.
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

/// Returns the form of `algebraic_loops`: a word, or the options of their solution.
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

/// Values of a map at `solver`.
struct ControlledSolver {
  std::string name;
  double relative = ErrorControl{}.relative, absolute = ErrorControl{}.absolute;
  std::int64_t max_steps = ErrorControl{}.max_steps;
};

using SolverTable = yaml::KeyTable<ControlledSolver, HeadReading>;

const SolverTable& solver_table() {
  static const yaml::Key above_zero = form::above_zero(form::number());
  static const SolverTable table(
      "solver", "{name: dormand_prince, relative: 1e-6}",
      {yaml::needed(SolverTable::Row{"name", "auto, or the name of a solver that estimates its error",
                                     form::text(), &ControlledSolver::name}),
       {"relative", "error of a step that is allowed, in parts of each state", above_zero,
        &ControlledSolver::relative},
       {"absolute", "the same where a state is near 0, in its own SI unit", above_zero,
        &ControlledSolver::absolute},
       {"max_steps", "steps between two instants beyond which the run ends", form::whole(1),
        &ControlledSolver::max_steps}});
  return table;
}

void read_solver(Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
  diagram.solver_origin = read.origin;
  diagram.error_control.reset();
  if (node.is_scalar()) {
    read.take(node, {}, diagram.solver);
    for (const char* always : {"auto", "dop853", "rodas", "radau"})
      if (diagram.solver == always) diagram.error_control.emplace();
    return;
  }
  ControlledSolver solver;
  if (!solver_table().read(node, solver, read)) return;
  diagram.solver = solver.name;
  diagram.error_control = ErrorControl{solver.relative, solver.absolute, solver.max_steps};
}

using EventsTable = yaml::KeyTable<Events, HeadReading>;

const EventsTable& events_table() {
  static const EventsTable table(
      "events", "{max_per_step: 20}",
      {{"max_per_step", "events in one step beyond which the run ends", form::whole(1),
        &Events::max_per_step},
       {"rounds", "how often blocks may change each other at one instant before the run ends", form::whole(1),
        &Events::rounds},
       {"looks",
        "how often a step is looked into for what crosses twice in it: up to 4 where a number comes near to "
        "0, "
        "above 4 every step",
        form::whole(0), &Events::looks}});
  return table;
}

/// Returns the form of `events`: a word, or the options of their location.
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

HeadRow solver_row() {
  static const yaml::Key form = form::either({form::text(), solver_table().form});
  return {
      "solver",
      "how continuous states go from tick to tick; none where there are none. A name, or with control of the "
      "error: {name: dormand_prince, relative: 1e-6, absolute: 1e-9}",
      form, read_solver};
}

HeadRow events_row() {
  return yaml::otherwise("tick",
                         HeadRow{"events",
                                 "what becomes of limits, switches and edges between two ticks: locate, or "
                                 "how: {max_per_step: 20}",
                                 events_form(), read_events});
}

}  // namespace stepwire::diagram
