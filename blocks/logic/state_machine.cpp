#include "blocks/logic/state_machine.hpp"

#include <fmt/format.h>

#include <cmath>

#include "blocks/logic/chart_reader.hpp"
#include "engine/base/expression/margin.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

double number_of(std::size_t index) {
  return index == ChartState::none ? -1.0 : static_cast<double>(index);
}

/// Flattened lists with their begins: {{a, b}, {}, {c}} begin at 0, 2, 2 and end at 3.
class Flat {
 public:
  void begin() { first_.push_back(static_cast<double>(formulas_.size())); }
  void add(std::size_t what, const ChartFormula& formula) {
    what_.push_back(static_cast<double>(what));
    formulas_.push_back(formula);
  }
  void add(const std::vector<ChartSetting>& settings) {
    begin();
    for (const ChartSetting& setting : settings) add(setting.counter, setting.value);
  }
  Numbers first() {
    begin();
    return Numbers(first_);
  }
  Numbers what() const { return Numbers(what_); }
  const std::vector<ChartFormula>& formulas() const { return formulas_; }
  std::vector<ChartFormula> margins() const {
    std::vector<ChartFormula> margins;
    for (const ChartFormula& guard : formulas_)
      margins.push_back({expression::margin_of(guard.formula), guard.places});
    return margins;
  }

 private:
  std::vector<double> first_, what_;
  std::vector<ChartFormula> formulas_;
};

void take_states(StateMachine& machine, const std::vector<ChartState>& states) {
  std::vector<double> values, parent, inner, history;
  for (const ChartState& state : states) {
    values.insert(values.end(), state.output.begin(), state.output.end());
    parent.push_back(number_of(state.parent));
    inner.push_back(number_of(state.initial));
    history.push_back(state.history ? 1.0 : 0.0);
    machine.remembers = machine.remembers || state.history;
    Index level = 1;
    for (std::size_t s = state.parent; s != ChartState::none; s = states[s].parent) ++level;
    machine.levels = std::max(machine.levels, level);
  }
  machine.values = Numbers(values);
  machine.parent = Numbers(parent);
  machine.inner = Numbers(inner);
  machine.history = Numbers(history);
}

void take_transitions(StateMachine& machine, const std::vector<ChartState>& states, std::size_t choice) {
  Flat to, set;
  for (const ChartState& state : states) {
    to.begin();
    for (const ChartTransition& transition : state.to) to.add(transition.target, transition.guard);
    set.add(state.enter);
    set.add(state.exit);
    set.add(state.each);
  }
  for (const ChartState& state : states)
    for (const ChartTransition& transition : state.to) set.add(transition.set);
  machine.first_to = to.first();
  machine.target = to.what();
  machine.guard = choice_of(to.formulas(), choice);
  machine.margin = choice_of(to.margins(), choice);
  machine.first_setting = set.first();
  machine.set_counter = set.what();
  machine.setting = choice_of(set.formulas(), choice);
  machine.sets = !set.formulas().empty();
}

/// Reads the counters' names and initial values.
std::vector<std::string> read_counters(StateMachine& machine, const Configure& is) {
  const Value tree = machine.counters.value();
  std::vector<std::string> names;
  std::vector<double> first;
  if (tree.map())
    for (const auto& [name, value] : *tree.map()) {
      double number = std::nan("");
      try {
        if (value.text())
          number = expression::Expression(*value.text(), [](std::string_view) { return false; })({});
      } catch (const expression::ExpressionError&) {
      }
      if (!std::isfinite(number))
        is.refuse<&StateMachine::counters>(fmt::format("'{}' needs a number to begin with", name), value);
      names.push_back(name);
      first.push_back(number);
    }
  if (static_cast<Index>(names.size()) > StateMachine::max_counters)
    is.refuse<&StateMachine::counters>(
        fmt::format("{} are more than {}", names.size(), StateMachine::max_counters));
  machine.first_counts = Numbers(first);
  return names;
}

void check_inputs(const StateMachine& machine, std::size_t inputs, const Configure& is) {
  if (inputs > StateMachine::max_inputs)
    is.refuse<&StateMachine::states>(
        fmt::format("{} inputs are more than {}", inputs, StateMachine::max_inputs));
  if (!machine.variables.empty() && machine.variables.size() != inputs)
    is.refuse<&StateMachine::variables>(fmt::format("{} for {}; each needs one",
                                                    text::there_are(machine.variables.size(), "name"),
                                                    text::counted(inputs, "input")));
}

/// Returns the initial state of the chart, from which all others must be reachable.
std::size_t start_of(const StateMachine& machine, const ChartReader& reader, const Configure& is) {
  const std::string wanted(machine.initial.view());
  const std::size_t start = wanted.empty() ? 0 : reader.find(wanted);
  if (start == ChartReader::none)
    is.refuse<&StateMachine::initial>("there is no state '" + wanted + "'; the states are " + reader.names());
  reader.refuse_unreachable(start);
  return start;
}

/// Returns the largest number of transitions of a state and those that hold it; at least 1.
Index most_transitions(const std::vector<ChartState>& states) {
  std::size_t most = 1;
  for (const ChartState& state : states) {
    std::size_t here = state.to.size();
    for (std::size_t s = state.parent; s != ChartState::none; s = states[s].parent)
      here += states[s].to.size();
    most = std::max(most, here);
  }
  return static_cast<Index>(most);
}

}  // namespace

template <>
void StateMachine::declare(Declare<StateMachine>& is) {
  is.block(
      "StateMachine",
      {.doc =
           "Finite state machine (chart). `states` is a map of name: {output: [..], to: {target: guard, "
           "..}}. At "
           "each tick the guards of the active state are read in the order of the file, and the first that "
           "is "
           "not 0 changes the state, at most once per tick; the outputs show the new state at the same tick. "
           "A "
           "guard is a formula of u1, u2, ... (u where there is one) or of the names in `variables`, of the "
           "counters, and of `after`, the time since the state was entered: \"u1 > 5 mm && after >= 2 s\". "
           "A guard that compares different units is refused. "
           "`timeout: {target: 3 s}` leads on after a time, where no other transition does. `to` may be a "
           "list of "
           "{to: target, when: guard, priority: 1, set: {..}}: 1 comes before 2, and both before those "
           "without. "
           "A state may hold others: `states`, `initial` (the first where left out) and `history: true` to "
           "go "
           "on with the one that was left; its own transitions come before theirs, and what it holds has its "
           "output where it gives none. `enter`, `exit` and `each` (tick that it stays) set `counters`: "
           "{enter: "
           "{tries: tries + 1}}. Outputs are numbers, 0 where a state gives none. In figures and claims the "
           "state is a word: m.state == \"on.fast\". States that cannot be reached are refused. "
           "With `events: locate` a transition acts where its guard begins to hold, also a timeout, between "
           "ticks as well. A part that is held keeps the time in its states, also where it is switched off "
           "or "
           "on between ticks. "
           "An instant has one transition at most, so a guard that holds on entry acts at the next tick or "
           "event; a machine with `every` keeps to its ticks.",
       .source = "D. Harel, Statecharts, Sci. Comput. Program. 8 (1987) 231, without parallel states",
       .at_events = true});
  is.parameter<&StateMachine::states>(
      {.doc = "the states, each with its output and transitions",
       .required = true,
       .formulas = {"to.", "when", "timeout", "enter", "exit", "each", "set"}});
  is.parameter<&StateMachine::counters>(
      {.doc = "numbers that states set and guards read, with their first values: {tries: 0}"});
  is.parameter<&StateMachine::variables>({.doc = "names of the inputs in formulas, in their order: "
                                                 "[temperature, door]; u1, u2, ... where left out"});
  is.parameter<&StateMachine::initial>(
      {.doc = "name of the first state; the first of the file where left out"});
  is.input<&StateMachine::u>(
      {.unit = "*", .shape = "1", .doc = "numbers that guards read", .optional = true});
  is.output<&StateMachine::state>(
      {.doc =
           "index of the active state in the order of the file from 0, each behind the one that holds it"});
  is.output<&StateMachine::y>(
      {.unit = "*", .shape = "m", .doc = "output of the active state; one 0 if none gives any"});
  is.output<&StateMachine::counts>(
      {.unit = "*", .shape = "c", .doc = "the counters in the order of the file; one 0 if there are none"});
  is.state<&StateMachine::active>({.doc = "index of the active state", .settable = false});
  is.state<&StateMachine::begun>({.doc = "0 before the first tick, then 1", .settable = false});
  is.state<&StateMachine::ticks>(
      {.shape = "l", .doc = "ticks since it and those that hold it were entered", .settable = false});
  is.state<&StateMachine::late>(
      {.unit = "s", .shape = "l", .doc = "time from the tick before to their entry", .settable = false});
  is.state<&StateMachine::last_tick>({.unit = "s", .doc = "time of the last tick", .settable = false});
  is.state<&StateMachine::moved_at>({.unit = "s", .doc = "time of the last transition", .settable = false});
  is.state<&StateMachine::acted_at>({.unit = "s", .doc = "time of the last update", .settable = false});
  is.state<&StateMachine::seen_at>(
      {.unit = "s", .doc = "last time at which its part was active, if located", .settable = false});
  is.state<&StateMachine::kept>({.unit = "*", .shape = "c", .doc = "the counters", .settable = false});
  is.state<&StateMachine::past>(
      {.shape = "h", .doc = "the state that each held when it was left, -1 for none", .settable = false});
  is.clock<&StateMachine::period>();
  is.clock<&StateMachine::time>();
  is.crossing<&StateMachine::u>("a guard of the active state begins to hold", "g");
  is.derived<&StateMachine::guard>();
  is.derived<&StateMachine::margin>();
  is.derived<&StateMachine::setting>();
  is.derived<&StateMachine::values>();
  is.derived<&StateMachine::parent>();
  is.derived<&StateMachine::inner>();
  is.derived<&StateMachine::history>();
  is.derived<&StateMachine::first_to>();
  is.derived<&StateMachine::target>();
  is.derived<&StateMachine::first_setting>();
  is.derived<&StateMachine::set_counter>();
  is.derived<&StateMachine::first_counts>();
  is.derived<&StateMachine::first>();
  is.derived<&StateMachine::levels>();
  is.derived<&StateMachine::located>();
  is.derived<&StateMachine::remembers>();
  is.derived<&StateMachine::sets>();
}

template <>
void StateMachine::configure(Configure& is) {
  const auto inputs = static_cast<std::size_t>(is.count<&StateMachine::u>());
  check_inputs(*this, inputs, is);
  remembers = sets = false;
  levels = 1;
  const ChartNames names{variables, inputs, read_counters(*this, is)};
  const Value tree = states.value();
  const ChartReader reader(tree, names, [&](const std::string& message, const Value& where) {
    is.refuse<&StateMachine::states>(message, where);
  });
  if (reader.states().size() > max_states)
    is.refuse<&StateMachine::states>(fmt::format("{} are more than {}", reader.states().size(), max_states));
  first = static_cast<Index>(reader.leaf_of(start_of(*this, reader, is)));
  take_states(*this, reader.states());
  if (levels > max_depth)
    is.refuse<&StateMachine::states>(fmt::format("states stand {} deep; at most {} may", levels, max_depth));
  take_transitions(*this, reader.states(), names.after() + 1);
  located = most_transitions(reader.states());
  is.size("g", located);
  is.size("m", static_cast<Index>(reader.states()[0].output.size()));
  is.size("c", std::max<Index>(first_counts.size(), 1));
  is.size("l", levels);
  is.size("h", remembers ? parent.size() : 1);
}

}  // namespace stepwire
