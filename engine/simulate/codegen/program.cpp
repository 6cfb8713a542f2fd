#include "engine/simulate/codegen/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/model/diagram/external_input.hpp"
#include "engine/model/plan/run_ends.hpp"
#include "engine/simulate/codegen/between_ticks.hpp"
#include "engine/simulate/codegen/event_text.hpp"
#include "engine/simulate/codegen/guard_text.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"
#include "engine/simulate/codegen/runs.hpp"
#include "engine/simulate/codegen/solver_text.hpp"
#include "engine/simulate/codegen/statements.hpp"
#include "engine/simulate/codegen/times_ahead.hpp"
#include "engine/simulate/codegen/workspace_text.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

/// Generates functions from pieces of code. Long ones are split, since the compile time of a function grows
/// faster than its length.
class Functions {
 public:
  /// With `small`, functions are inlined, which pays if the compiler can then keep numbers in registers.
  explicit Functions(bool small) : small_(small) {}

  /// Adds a function with these parameters, which calls `code` at its due ticks.
  void add(const std::string& name, const std::string& parameters, const std::string& arguments,
           const std::vector<Code>& code);
  void add_text(const std::string& text) { text_ += text; }
  const std::string& text() const { return text_; }
  /// Returns the attribute of a function that may be inlined.
  std::string attribute() const;

 private:
  bool small_;
  std::string text_;
};

constexpr std::size_t longest = 60;  // pieces of code per function

std::string Functions::attribute() const {
  return small_ ? "[[gnu::always_inline, gnu::flatten, maybe_unused]] inline"
                : "[[gnu::noinline, gnu::flatten, maybe_unused]] inline";
}

void Functions::add(const std::string& name, const std::string& parameters, const std::string& arguments,
                    const std::vector<Code>& code) {
  if (code.size() <= longest || small_) {
    text_ += fmt::format("{} void {}({}) {{\n{}}}\n\n", attribute(), name, parameters,
                         with_conditions(code, 0, code.size()));
    return;
  }
  std::string calls;
  for (std::size_t first = 0, part = 1; first < code.size(); first += longest, ++part) {
    text_ += fmt::format("{} void {}_{}({}) {{\n{}}}\n\n", attribute(), name, part, parameters,
                         with_conditions(code, first, std::min(first + longest, code.size())));
    calls += fmt::format("  {}_{}({});\n", name, part, arguments);
  }
  text_ += fmt::format("inline void {}({}) {{\n{}}}\n\n", name, parameters, calls);
}

/// Statements that set the numbers of the workspace before the first tick.
class StartText {
 public:
  /// `places` maps places of variable numbers in the workspace to places in the table that they are read
  /// from.
  StartText(const plan::Plan& plan, const PlaceNames& names, const std::map<std::size_t, std::size_t>& places)
      : plan_(plan), names_(names), places_(places) {}

  /// Returns the statements for constants on wires.
  std::string constants() const;
  /// Returns the statements for all blocks; all other numbers must be 0 before.
  std::vector<Code> initial() const;

 private:
  std::string number_at(std::size_t place, double number) const;
  void add_initial(std::size_t block, std::vector<Code>& code) const;

  const plan::Plan& plan_;
  const PlaceNames& names_;
  const std::map<std::size_t, std::size_t>& places_;
};

std::string StartText::constants() const {
  std::string text;
  for (std::size_t i = 0; i < plan_.constants.size(); ++i)
    text += fmt::format("  w[{}] = {};\n", plan_.layout.constants + i,
                        number_at(plan_.layout.constants + i, plan_.constants[i]));
  return text;
}

std::vector<Code> StartText::initial() const {
  std::vector<Code> code;
  for (const int block : plan_.memory_order) add_initial(static_cast<std::size_t>(block), code);
  return code;
}

/// Returns a number as a literal, or the table entry that it is read from.
std::string StartText::number_at(std::size_t place, double number) const {
  const auto found = places_.find(place);
  return found == places_.end() ? number_text(number) : fmt::format("numbers[{}]", found->second);
}

void StartText::add_initial(std::size_t b, std::vector<Code>& code) const {
  const diagram::DiagramBlock& block = plan_.diagram.blocks[b];
  const plan::PlannedBlock& planned = plan_.blocks[b];
  const auto assign = [&](const plan::SignalSlot& slot, bool always, const auto& value) {
    std::string text;
    for (Index k = 0; k < slot.size; ++k)
      if (const std::string number = number_at(slot.offset + static_cast<std::size_t>(k), value(k));
          always || number != "0.0")
        text += fmt::format("  w[{} + {}] = {};\n", names_.at(slot.offset), k, number);
    if (!text.empty()) code.push_back({std::move(text)});
  };
  for (std::size_t s = 0; s < planned.states.size(); ++s)
    assign(planned.states[s], false, [&](Index) { return block.type().states[s].initial; });
  for (const diagram::InitialValue& initial : block.initial)
    assign(planned.states[static_cast<std::size_t>(initial.state)], true,
           [&](Index k) { return initial.value[initial.value.size() == 1 ? 0 : k]; });
  if (&block.type() == &diagram::external_input_type()) {
    const PerElement& value = static_cast<const diagram::ExternalInput*>(block.block.get())->value;
    assign(planned.outputs.front(), false, [&](Index k) { return value[k]; });
  }
}

bool is_in(const plan::KernelCall& batch, const plan::Plan& plan, const plan::PlannedBlock& block) {
  const auto index = static_cast<std::size_t>(&block - plan.blocks.data());
  const Kernels& kernels = plan.diagram.blocks[index].type().run_outputs;
  return block.memory >= batch.first && block.memory < batch.end && kernels.contains(batch.run);
}

/// Returns the places of a solver stage with numbers of its own: the signals that it computes, the time and
/// the states are in `s`.
Places stage_places(const plan::Plan& plan, Places places) {
  places.fresh = "s";
  places.is_fresh.assign(plan.layout.derivatives + plan.layout.state_count, false);
  places.is_fresh[plan::Layout::time] = true;
  for (std::size_t i = plan.layout.states; i < plan.layout.derivatives; ++i) places.is_fresh[i] = true;
  for (const plan::KernelCall& batch : plan.stage)
    for (const plan::PlannedBlock& block : plan.blocks)
      if (batch.active < 0 && is_in(batch, plan, block))
        for (const plan::SignalSlot& slot : block.outputs)
          std::fill_n(places.is_fresh.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, true);
  return places;
}

/// Returns the count of blocks that a table of a plan calls.
std::size_t count_of(const std::vector<plan::KernelCall>& batches) {
  std::size_t count = 0;
  for (const plan::KernelCall& batch : batches) count += batch.count;
  return count;
}

constexpr std::size_t max_inlined = 150;  // calls in a stage; larger ones lack registers

const std::string state_arguments = "w, numbers, tick";
const std::map<std::size_t, std::size_t> no_places;

class Maker {
 public:
  Maker(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable,
        const std::map<std::size_t, std::size_t>& places, LanePlaces lanes = {})
      : plan_(plan),
        lanes_(std::move(lanes)),
        ahead_(plan, lanes_),
        names_(plan),
        start_(plan, names_, places),
        literals_(in_lanes() ? "numbers.lane(l)" : "numbers"),
        statements_(plan, names_, variable, lanes_, literals_),
        small_(count_of(plan.stage) + count_of(plan.derivatives) <= max_inlined &&
               !solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value()) &&
               plan.loops.empty()),
        functions_(small_) {}

  void add_steps() {
    if (!plan_.timed.empty()) add_timed();
    for (std::size_t guard = plan_.guards.size(); guard-- > 0;) add_guard(guard);  // callees first
    add_outputs();
    add_updates();
    if (plan_.layout.state_count > 0) add_slopes();
    if (!plan_.end_updates.empty()) add_end();
    if (!plan_.left_updates.empty()) add_left();
    if (plan_.splits_steps()) add_events();
    add_advance();
  }

  void add_reset() {
    std::vector<Code> code = start_.initial();
    append(code, starts_of(plan_, statements_, at_tick(), plan_.memory_order));
    const std::string parameters = "[[maybe_unused]] double* w, [[maybe_unused]] const double* numbers";
    functions_.add("start", parameters, "w, numbers", code);
    functions_.add("once", parameters, "w, numbers",
                   calls_of(plan_, statements_, plan_.once, Phase::outputs, at_tick()));
    functions_.add_text(
        fmt::format("inline void reset(double* w, const double* numbers) {{\n"
                    "  for (int i = 0; i < size; ++i) w[i] = 0.0;\n"
                    "  w[at::timed] = {3};\n"
                    "  for (int i = {0}; i < {1}; ++i) w[i] = Diagnostic::never;\n{2}"
                    "  start(w, numbers);\n  once(w, numbers);\n}}\n",
                    plan_.layout.diagnostics, plan_.layout.diagnostics + plan_.layout.diagnostic_count,
                    start_.constants(), number_text(plan::Layout::never)));
  }

  void add_follow() {
    functions_.add_text(
        fmt::format("\ninline void follow_values(double* w, [[maybe_unused]] const double* numbers) {{\n{}"
                    "  w[at::timed] = {};\n  once(w, numbers);\n{}}}\n",
                    start_.constants(), number_text(plan::Layout::never),
                    plan_.rest.empty() ? "" : "  w[" + ahead_place() + "] = 0.0;\n"));
  }

  /// Adds the evaluations for external solvers.
  void add_between_ticks() {
    add_evaluation("here", plan_.outputs);
    if (!plan_.between.empty()) add_evaluation("between", plan_.between);
  }

  /// Adds a function that computes these outputs and the derivatives. Diagnostics that blocks raise in it are
  /// valid for this evaluation only.
  void add_evaluation(const std::string& name, const std::vector<plan::KernelCall>& outputs) {
    std::vector<Code> code{{plan_.timed.empty() ? "" : "  follow_time(w, numbers);\n"}};
    append(code, outputs_of(outputs));
    functions_.add("outputs_" + name, state_parameters(), state_arguments, code);
    functions_.add_text(
        fmt::format("inline void evaluate_{3}(double* w, const double* numbers) {{\n"
                    "  for (int i = {0}; i < {1}; ++i) w[i] = Diagnostic::never;\n"
                    "  outputs_{3}(w, numbers, 0);\n{2}}}\n\n",
                    plan_.layout.diagnostics, plan_.layout.diagnostics + plan_.layout.diagnostic_count,
                    slopes_of_evaluation(plan_), name));
  }

  void add_lanes() {
    add_steps();
    functions_.add_text(lane_steps_text(plan_, lanes_, ahead_.memory_text(), ahead_.tick_text()));
  }

  GeneratedProgram program() const;

 private:
  bool in_lanes() const { return lanes_.lanes > 1; }
  std::string state_parameters() const {
    return workspace_parameters(lanes_) + ", [[maybe_unused]] std::int64_t tick";
  }

  void add_timed() {
    const std::string parameters = workspace_parameters(lanes_);
    functions_.add("timed", parameters, "w, numbers",
                   calls_of(plan_, statements_, plan_.timed, Phase::outputs, at_tick()));
    if (ahead_.possible()) add_times_ahead();
    functions_.add_text(
        fmt::format("/// Computes what follows from the time alone, if it has changed.\n"
                    "{} void follow_time({}) {{\n"
                    "  if (w[at::timed] == w[at::time]) return;\n"
                    "  w[at::timed] = w[at::time];\n{}  timed(w, numbers);\n}}\n\n",
                    functions_.attribute(), parameters, ahead_.possible() ? ahead_.take_text() : ""));
  }

  void add_times_ahead() {
    const std::vector<Code> code =
        calls_of(plan_, statements_, plan_.timed, Phase::outputs, ahead_.places(at_tick()));
    functions_.add_text(ahead_.fill_text(functions_.attribute(), with_conditions(code, 0, code.size())));
  }

  /// Adds the functions for a guard that switches off and on.
  void add_guard(std::size_t guard) {
    const plan::PlannedGuard& of = plan_.guards[guard];
    functions_.add_text(fmt::format("inline void off_{}([[maybe_unused]] double* w) {{\n{}}}\n\n", guard,
                                    off_text(names_, plan_, guard)));
    std::vector<Code> code{{reset_text(of)}};
    append(code, starts_of(plan_, statements_, at_tick(), {of.start.begin(), of.start.end()}));
    functions_.add(fmt::format("reset_{}", guard),
                   "[[maybe_unused]] double* w, [[maybe_unused]] const double* numbers", "w, numbers", code);
  }

  void add_outputs() {
    std::vector<Code> code{{stop_guard() + "  w[at::time] = " + time_text(plan_, "tick") + ";\n"}};
    if (!plan_.timed.empty()) code.front().text += "  follow_time(w, numbers);\n";
    if (plan_.rest.empty()) {
      append(code, outputs_of(plan_.outputs));
    } else {
      functions_.add("ahead", state_parameters(), state_arguments, outputs_of(plan_.ahead));
      code.push_back({fmt::format("  if (w[{}] == 0.0) ahead({});\n", ahead_place(), state_arguments)});
      append(code, outputs_of(plan_.rest));
    }
    if (plan_.splits_steps()) code.push_back({fmt::format("  w[{}] = 0.0;\n", ahead_place())});
    functions_.add("evaluate", state_parameters(), state_arguments, code);
  }

  std::vector<Code> outputs_of(const std::vector<plan::KernelCall>& table) const {
    return calls_of(plan_, statements_, table, Phase::outputs, at_tick());
  }

  /// Returns the statement that keeps a run ended after a stop between two ticks.
  std::string stop_guard() const {
    if (!plan::may_end_between(plan_)) return "";
    return fmt::format("  if (w[{}] != 0.0) return;\n", plan_.layout.events + solve::EventReport::stopped);
  }
  std::string ahead_place() const { return std::to_string(plan_.layout.events + solve::EventReport::ahead); }

  void add_updates() {
    functions_.add("update", state_parameters(), state_arguments,
                   calls_of(plan_, statements_, plan_.updates, Phase::update, at_tick()));
  }

  void add_end() {
    functions_.add("updates_at_end", state_parameters(), state_arguments,
                   calls_of(plan_, statements_, plan_.end_updates, Phase::update, at_tick()));
  }

  /// Adds the updates of blocks that read their inputs just before each instant.
  void add_left() {
    std::vector<Code> code = outputs_of(plan_.lefts);
    append(code, calls_of(plan_, statements_, plan_.left_updates, Phase::update_before_instant, at_tick()));
    functions_.add("updates_before", state_parameters(), state_arguments, code);
    functions_.add_text(fmt::format(
        "{} void before_instant({}, double time) {{\n  w[at::time] = {};\n{}  updates_before({});\n"
        "  w[at::time] = time;\n}}\n\n",
        functions_.attribute(), state_parameters(), plan_.jumps ? "solve::left_of(time, step)" : "time",
        plan_.timed.empty() ? "" : "  follow_time(w, numbers);\n", state_arguments));
  }

  Places at_workspace() const {
    Places places;
    if (in_lanes()) places.dot = "w.from(first_derivative)";
    return places;
  }

  /// Returns the places at a tick. A small program is inlined, so all its numbers can be in registers.
  Places at_tick() const {
    Places places = at_workspace();
    if (small_) places.min_in_loop = max_inlined + 1;
    return places;
  }

  void add_slopes() {
    const std::string slopes = ", " + numbers_parameter(lanes_, "dot");
    Places tick = at_tick();
    tick.dot = "dot";
    std::vector<Code> at_start = given_slopes();
    if (small_ && !plan_.guards.empty()) at_start.push_back({zero_slopes_text(plan_)});
    append(at_start, calls_of(plan_, statements_, plan_.derivatives, Phase::derivatives, tick));
    functions_.add("derivatives", workspace_parameters(lanes_) + slopes, "w, numbers, dot", at_start);
    Places at_stage = small_ ? stage_places(plan_, at_tick()) : at_tick();
    at_stage.dot = "dot";
    std::vector<Code> code = calls_of(plan_, statements_, plan_.stage, Phase::outputs, at_stage);
    append(code, calls_of(plan_, statements_, plan_.derivatives, Phase::derivatives, at_stage));
    for (Code& piece : code) piece.period = {};  // a stage computes all its calls
    functions_.add("slopes", workspace_parameters(lanes_) + ", " + numbers_parameter(lanes_, "s") + slopes,
                   "w, numbers, s, dot", code);
  }

  /// Returns statements for derivatives that outputs have written to the workspace, if derivatives have a
  /// place of their own.
  std::vector<Code> given_slopes() const {
    std::vector<Code> code;
    if (!small_) return code;
    for (const plan::PlannedBlock& block : plan_.blocks)
      for (const plan::SignalSlot& slot : block.derivatives)
        for (std::size_t i = slot.offset; i < slot.offset + static_cast<std::size_t>(slot.size); ++i)
          if (block.slope_is_input && i >= plan_.layout.derivatives)  // discrete states have no derivatives
            code.push_back({given_slope_text(plan_, lanes_, i)});
    return code;
  }

  void add_advance() {
    const bool moves = plan_.layout.state_count > 0, splits = plan_.splits_steps();
    std::string body = stop_guard() + update_text(plan_);
    if (moves) {
      body += times_of_step_text(plan_) + keep_text(names_, plan_);
      if (plan_.updates_continuous) {
        const std::vector<Code> stage =
            calls_of(plan_, statements_, plan_.stage, Phase::outputs, at_workspace());
        body += with_conditions(stage, 0, stage.size());
      }
    }
    if (splits) body += before_step_text(plan_);
    if (moves && !(splits && watches(plan_))) body += solver_text(plan_, {.small = small_, .lanes = lanes_});
    if (splits) body += after_step_text(plan_);
    body += end_of_left_text(plan_);
    functions_.add_text(
        fmt::format("[[gnu::flatten]] inline void advance({}) {{\n{}}}\n\n", state_parameters(), body));
  }

  /// Adds the outputs and updates of events.
  void add_event_calls() {
    const auto add = [&](const char* name, const std::vector<Code>& code) {
      functions_.add(name, state_parameters(), state_arguments, code);
    };
    std::vector<Code> ends = outputs_of(plan_.ahead);
    append(ends, outputs_of(plan_.crossing_outputs));
    add("crossing_ends", ends);
    add("crossing_starts", outputs_of(plan_.crossing_starts));
    if (!plan_.event_befores.empty()) add("event_befores", outputs_of(plan_.event_befores));
    add("event_outputs", outputs_of(plan_.event_outputs));
    add("event_updates", calls_of(plan_, statements_, plan_.event_updates, Phase::update, at_tick()));
  }

  /// Adds the crossing functions and the event iteration. The latter is compiled apart from the step, and for
  /// speed as well: a step with an event takes many steps of the solver.
  void add_events() {
    add_event_calls();
    const std::string often = functions_.attribute(), apart = "[[gnu::noinline]] inline",
                      whole = "[[gnu::noinline, gnu::flatten]] inline";
    const auto add_text = [&](const std::string& head, const std::string& parameters,
                              const std::string& body) {
      functions_.add_text(fmt::format("{}({}) {{\n{}}}\n\n", head, parameters, body));
    };
    const std::string at_state = state_parameters();
    add_text(often + " void look", at_state + ", double* z", look_text(plan_, statements_, at_tick()));
    add_text(often + " double next_edge", at_state, edge_text(plan_, statements_, at_tick()));
    if (plan_.layout.state_count > 0)
      add_text(whole + " void slopes_in_place", "double* w, [[maybe_unused]] const double* numbers",
               "  slopes(w, numbers, w, w + first_derivative);\n");
    add_text(whole + " void follow_crossings", at_state, "  crossing_ends(" + state_arguments + ");\n");
    if (plan_.updates_continuous) add_text(apart + " bool settle_tick", at_state, settle_text(plan_, names_));
    add_text(apart + " void locate", at_state + ", double* scratch", locate_text(plan_, names_));
  }

  static void append(std::vector<Code>& to, std::vector<Code> more) {
    std::move(more.begin(), more.end(), std::back_inserter(to));
  }

  const plan::Plan& plan_;
  LanePlaces lanes_;
  TimesAhead ahead_;
  PlaceNames names_;
  StartText start_;
  Literals literals_;
  Statements statements_;
  bool small_;
  Functions functions_;
};

GeneratedProgram Maker::program() const {
  return {.text = places_text(plan_, names_) + tables_text(literals_) + functions_.text(),
          .headers = headers_of(plan_),
          .uses_libm = plan_.diagram.uses_libm};
}

}  // namespace

GeneratedProgram make_program(const plan::Plan& plan, const Tuning& tuning, bool between_ticks) {
  require_headers(plan);
  Maker maker(plan, tuning.variable, tuning.places);
  maker.add_steps();
  if (between_ticks) maker.add_between_ticks();
  maker.add_reset();
  if (tuning.parameters.empty()) return maker.program();
  maker.add_follow();
  GeneratedProgram program = maker.program();
  if (std::ranges::count(program.headers, language_header) == 0)
    program.headers.emplace_back(language_header);
  return program;
}

GeneratedProgram make_steps(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable) {
  require_headers(plan);
  Maker maker(plan, variable, no_places);
  maker.add_steps();
  return maker.program();
}

GeneratedProgram make_lanes(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes) {
  require_headers(plan);
  Maker maker(plan, differences.variable, no_places, lane_places(plan, differences, lanes));
  maker.add_lanes();
  GeneratedProgram program = maker.program();
  program.lanes = lanes;
  program.headers.insert(program.headers.end(),
                         {"engine/model/plan/lane_task.hpp", "engine/model/signal/lanes.hpp"});
  return program;
}

}  // namespace stepwire::codegen
