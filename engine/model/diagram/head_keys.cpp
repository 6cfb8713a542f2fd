#include "engine/model/diagram/head_keys.hpp"

#include <fmt/format.h>

#include <set>

#include "engine/model/diagram/uses.hpp"

namespace stepwire::diagram {

using yaml::form;

namespace {

using HeadRow = yaml::KeyRow<Diagram, HeadReading>;
using ReproductionTable = yaml::KeyTable<Reproduction, HeadReading>;

const char* const name_pattern = "^[A-Za-z_][A-Za-z0-9_]*$";
const char* const dotted_pattern = "^[A-Za-z_][A-Za-z0-9_]*([.][A-Za-z_][A-Za-z0-9_]*)*$";

constexpr double highest_number = 999'999;  // largest number of a figure

yaml::Key time_form() {
  return form::above_zero(form::number("s"));
}

HeadRow time_row(std::string name, std::string doc, double Diagram::*seconds, Origin Diagram::*origin) {
  const yaml::Key form = time_form();
  return {std::move(name), std::move(doc), form,
          [=](Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
            diagram.*origin = read.origin;
            read.take(node, form, diagram.*seconds);
          }};
}

void read_departures(Reproduction& reproduction, const yaml::Node& node, const HeadReading& read) {
  if (!node.is_list()) return read.fault(node.mark, "is a list of sentences: [the limit is 0.35 A, not 1 A]");
  for (const yaml::Node& item : node.items) read.take(item, {}, reproduction.departures.emplace_back());
}

const ReproductionTable& reproduction_table() {
  static const ReproductionTable table(
      "the original", "{figure: 15, section: 2.5.1}",
      {{"figure", "number of the figure", form::whole(0, highest_number), &Reproduction::figure},
       {"table", "number of the table", form::whole(0, highest_number), &Reproduction::table},
       {"section", "section in which it stands", form::text(), &Reproduction::section},
       {"caption", "caption of the figure, as printed", form::text(), &Reproduction::caption},
       {"says", "what its text says of the figure, word for word", form::text(), &Reproduction::says},
       {"departures", "what is done otherwise here, a sentence each", form::list(form::text()),
        read_departures}});
  return table;
}

// Treatment of algebraic loops and of threshold crossings in a step.

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

}  // namespace

bool always_controls_error(const std::string& solver) {
  static const std::set<std::string> names{"auto", "dop853", "rodas", "radau"};
  return names.contains(solver);
}

namespace {

void read_solver(Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
  diagram.solver_origin = read.origin;
  diagram.error_control.reset();
  if (node.is_scalar()) {
    read.take(node, {}, diagram.solver);
    if (always_controls_error(diagram.solver)) diagram.error_control.emplace();
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
        "how often a step is examined for what crosses twice in it: up to 4 where a number turns near 0, "
        "above "
        "4 every step",
        form::whole(0), &Events::looks}});
  return table;
}

/// Returns the row of what a merge has left open. Every file with such a section is refused.
HeadRow conflicts_row() {
  static const yaml::Key form = form::list(form::keys(
      "a conflict", "{at: spring.gain, base: 1, ours: 2, theirs: 3}",
      {yaml::needed(yaml::key("at", "the name that has two new values")),
       yaml::key("base", "its value before both changes"), yaml::key("ours", "its value on one side"),
       yaml::key("theirs", "its value on the other side")}));
  return {"conflicts",
          "what `stepwire merge` has left open: the file is refused until the section is removed", form};
}

HeadRow uses_row() {
  return {"uses", "repositories of git, each at one commit, whose files are parts: diagram: rig/oscillator",
          form::names(use_form(), 0, name_pattern)};
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

std::vector<HeadRow> run_rows() {
  return {
      time_row("step", "time between ticks: 1 ms", &Diagram::step, &Diagram::step_origin),
      time_row("stop", "end of the run, a whole multiple of the step: 5 s", &Diagram::stop,
               &Diagram::stop_origin),
      solver_row(),
      {"tolerance", "error of a step, in sizes of its state, beyond which rosenbrock and sdirk end the run",
       form::above_zero(form::number()), &Diagram::tolerance},
      loops_row(),
      events_row(),
      {"functions", "source of functions such as sin and exp in blocks, formulas and solvers",
       form::words(
           {{"portable", "the library SLEEF: the same bits on every x86-64 processor"},
            {"libm", "the C library of the machine: faster alone, with other last digits elsewhere"}}),
       &Diagram::uses_libm},
      {"stop_when", "ends the run early where this is true: rig.x > 5 mm, rig.position.1 > 5 mm",
       form::expression()},
      {"record", "signals that figures and claims read", form::one_or_list(form::section("record"))},
      {"sweep", "runs the file, or its whole study, once per value: parameter: {from, to, count} or [values]",
       form::section("sweep")},
      {"figure", "pictures of what was recorded", form::one_or_list(form::section("figure"))},
      {"scene",
       "objects that follow signals, as somebody at the device sees them: an animation, and `plot: scene`",
       form::section("scene")},
      {"claims", "statements that the run is held to", form::list(form::section("claim"))},
      {"invariants", "limits, energy and safety: what holds throughout any run; counted apart from claims",
       form::list(form::section("claim"))},
      {"fit", "finds parameters so that the model agrees with records: the runs of the sweep, or the one run",
       form::section("fit")},
      {"sensitivity", "how much of an outcome's spread comes from which parameter that a sweep draws",
       form::section("sensitivity")},
      {"tune", "what `tune` minimises, over which parameters, and the claims that hold meanwhile",
       form::section("tune")},
      {"linear",
       "linear analyses of the diagram near a point of its run, by name: poles, margins, responses, which "
       "figures and claims read",
       form::section("linear")},
      {"trim",
       "the operating point that `trim` and `linearize --trim` look for: where states stand still and "
       "signals "
       "have given values",
       form::section("trim")},
      {"study",
       "runs the file once for each person and condition, and scores and analyses these trials; beside a "
       "sweep, all of that at each of its points",
       form::section("study")},
      uses_row(),
      conflicts_row()};
}

}  // namespace

HeadReading::HeadReading(std::string subject, const Scope& scope, Report& report, const Origin& origin)
    : yaml::SectionReading(std::move(subject),
                           [&report, index = origin.scope](const yaml::Mark& mark, const std::string& about,
                                                           const yaml::Message& message) {
                             report.add({index, mark}, about, message);
                           }),
      scope(scope),
      report(report),
      origin(origin) {}

void HeadReading::take(const yaml::Node& node, const yaml::Key&, std::string& member) const {
  if (!node.is_scalar()) fault(node.mark, "a text is wanted here");
  member = node.text;
}

std::optional<double> HeadReading::read_number(const yaml::Node& node, const yaml::Key& key) const {
  const unit::Dimension dimension =
      key.unit.empty() ? unit::Dimension{} : unit::parse_unit(key.unit)->dimension;
  return ValueReader(scope.parameters, report, origin.scope).read_number(node, dimension, subject);
}

const std::vector<HeadRow>& head_rows() {
  static const std::vector<HeadRow> rows = [] {
    std::vector<HeadRow> all{
        yaml::needed(HeadRow{"stepwire", "format of this file; always 1", form::whole(1, 1)}),
        {"title", "one line on what is shown", form::text(), &Diagram::title},
        {"caption", "a few sentences for the gallery page", form::text(), &Diagram::caption},
        {"reproduces", "the figure or table of a publication that this file reproduces",
         reproduction_table().form,
         [](Diagram& diagram, const yaml::Node& node, const HeadReading& read) {
           reproduction_table().read(node, diagram.reproduces, read);
         }},
        {"parameters", "numbers and words with a name, used as $name; --set changes them",
         form::names(form::section("parameter"), 0, name_pattern)},
        {"inputs", "ports: what the file that uses this one as a part wires to it, or a program writes",
         form::names(form::section("input"), 0, name_pattern)},
        {"outputs", "ports: signals that the file that uses this one as a part sees, or a program reads",
         form::names(form::section("output"), 0, name_pattern)},
        {"units",
         "units of signals and their elements whose blocks cannot tell: {pull: N, kf.estimate.2: rad}",
         form::naming(yaml::Key::Names::signal, form::names(form::unit()))},
        yaml::needed(HeadRow{"blocks", "the blocks by name; an input is a key of its block",
                             form::names(form::section("block"), 1, dotted_pattern)})};
    for (HeadRow& row : run_rows()) all.push_back(std::move(row));
    return all;
  }();
  return rows;
}

const yaml::Key& head_form() {
  static const yaml::Key form =
      yaml::keys_form("a diagram", "{stepwire: 1, step: 1 ms, stop: 1 s, blocks: {..}}", head_rows());
  return form;
}

const yaml::Key& parameter_form() {
  static const yaml::Key form = [] {
    std::vector<yaml::Key> keys{
        yaml::needed(yaml::key("value", "the default: a number with unit, a list, a word, = expression",
                               form::tree())),
        yaml::key("unit", "unit of the value, where it stands apart: N/mm", form::unit()),
        yaml::key("doc", "what it is"),
        yaml::otherwise("false", yaml::key("assumed", "true: our guess, not from a source", form::truth()))};
    for (const char* bound : {"above", "below", "at_least", "at_most"})
      keys.push_back(yaml::key(bound, "a bound that --set and users of a part are held to", form::number()));
    return form::either({form::of(yaml::Key::Form::value),
                         form::keys("a parameter", "{value: 2 kg, doc: of the body}", keys)});
  }();
  return form;
}

const yaml::Key& input_form() {
  static const yaml::Key form = form::either(
      {form::of(yaml::Key::Form::nothing),
       form::keys("an input", "{unit: N, default: 0 N}",
                  {yaml::key("unit", "unit of what must be wired here", form::unit()),
                   yaml::key("shape", "elements of what must be wired here: 3, or 3 x 2", form::text()),
                   yaml::key("fields", "of a bus, with the unit of each: {force: N, torque: N m}",
                             form::of(yaml::Key::Form::tree)),
                   yaml::key("doc", "what it is"),
                   yaml::key("default", "feeds the port where the user gives nothing",
                             form::of(yaml::Key::Form::source))})});
  return form;
}

const yaml::Key& output_form() {
  static const yaml::Key form = form::either(
      {form::signal(),
       form::keys(
           "an output", "{signal: lag.y, unit: N}",
           {yaml::needed(yaml::key("signal", "a block or its output: carriage.position", form::signal())),
            yaml::key("unit", "unit that it must have", form::unit()), yaml::key("doc", "what it is"),
            yaml::key("shape", "elements that it must have: 3, or 3 x 2", form::text()),
            yaml::key("fields", "of a bus, with the unit of each: {force: N, torque: N m}",
                      form::of(yaml::Key::Form::tree)),
            yaml::key("safe", "what the output holds once a real-time loop has stopped: 0 A",
                      form::of(yaml::Key::Form::source))})});
  return form;
}

const yaml::Key& record_form() {
  const yaml::Key signal =
      yaml::key("", "a signal (rig.x), a state of a block (lag.x), or all", form::signal());
  static const yaml::Key form = form::either(
      {signal,
       form::keys(
           "an entry of record", "{every: 1 ms, signals: [rig.x]}",
           {yaml::otherwise("each step", yaml::key("every", "time between rows", time_form())),
            yaml::otherwise("false", yaml::key("instants",
                                               "a row before and a row after each instant: ticks, edges of "
                                               "sources, located events",
                                               form::truth())),
            yaml::needed(yaml::like(
                "[rig.x]",
                yaml::key("signals", "what is recorded",
                          form::one_or_list(form::either(
                              {signal, yaml::key("", "signals under names of your own: {position: rig.x}",
                                                 form::names(signal, 0, dotted_pattern))})))))})});
  return form;
}

}  // namespace stepwire::diagram
