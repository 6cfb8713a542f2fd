#include "engine/app/fmu/variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::fmu {

namespace {

/// Instantaneous dependencies of signals: the diagram inputs and the blocks with continuous states that
/// affect a signal at the same instant.
class Dependencies {
 public:
  explicit Dependencies(const plan::Plan& plan) : plan_(plan) {}

  std::set<int> of(const diagram::SignalRef& signal) const;
  /// Returns the dependencies of the derivatives of a block's states.
  std::set<int> of_slopes(int block) const;

 private:
  using Output = std::pair<int, int>;  ///< a block and the number of its output

  /// Returns the dependencies of outputs. A search over the wires meets each output once, also in an
  /// algebraic loop.
  std::set<int> of_outputs(std::vector<Output> open) const;
  std::vector<Output> sources_of(int block, std::size_t input) const;
  bool feeds_through(int block, std::size_t input, int output) const;
  void add_own(int block, std::set<int>& to) const;

  const plan::Plan& plan_;
};

bool Dependencies::feeds_through(int block, std::size_t input, int output) const {
  const auto b = static_cast<std::size_t>(block);
  const BlockType& type = plan_.diagram.blocks[b].type();
  const InputSpec& in = type.inputs[input];
  const auto& configuration = plan_.blocks[b].configuration;
  if (!configuration) return in.feedthrough;
  const auto said =
      configuration->feedthrough.find({in.name, type.outputs[static_cast<std::size_t>(output)].name});
  return said == configuration->feedthrough.end() ? in.feedthrough : said->second;
}

void Dependencies::add_own(int block, std::set<int>& to) const {
  const auto b = static_cast<std::size_t>(block);
  const bool is_input = std::ranges::any_of(
      plan_.diagram.inputs, [&](const diagram::DiagramInput& input) { return input.block == block; });
  if (is_input || plan_.diagram.blocks[b].type().has_continuous_state()) to.insert(block);
}

std::vector<Dependencies::Output> Dependencies::sources_of(int block, std::size_t input) const {
  std::vector<Output> sources;
  for (const diagram::Source& source : plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs[input])
    if (source.block >= 0) sources.emplace_back(source.block, source.output);
  return sources;
}

std::set<int> Dependencies::of_outputs(std::vector<Output> open) const {
  std::set<Output> seen(open.begin(), open.end());
  std::set<int> found;
  const auto add = [&](const Output& output) {
    if (seen.insert(output).second) open.push_back(output);
  };
  while (!open.empty()) {
    const auto [block, output] = open.back();
    open.pop_back();
    add_own(block, found);
    const diagram::DiagramBlock& of = plan_.diagram.blocks[static_cast<std::size_t>(block)];
    for (std::size_t input = 0; input < of.inputs.size(); ++input)
      if (feeds_through(block, input, output)) std::ranges::for_each(sources_of(block, input), add);
    if (of.guard >= 0) add({of.guard, 0});
  }
  return found;
}

std::set<int> Dependencies::of(const diagram::SignalRef& signal) const {
  if (signal.output >= 0) return of_outputs({{signal.block, signal.output}});
  std::set<int> own;
  add_own(signal.block, own);
  return own;
}

std::set<int> Dependencies::of_slopes(int block) const {
  std::vector<Output> sources;
  const std::size_t inputs = plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs.size();
  for (std::size_t input = 0; input < inputs; ++input) {
    const std::vector<Output> more = sources_of(block, input);
    sources.insert(sources.end(), more.begin(), more.end());
  }
  std::set<int> found = of_outputs(std::move(sources));
  add_own(block, found);
  return found;
}

/// Returns the names of inputs, outputs and recorded signals of a diagram.
std::set<std::string> signal_names(const diagram::Diagram& diagram) {
  std::set<std::string> names;
  for (const diagram::DiagramInput& input : diagram.inputs) names.insert(input.name);
  for (const diagram::DiagramOutput& output : diagram.outputs) names.insert(output.name);
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& recorded : request.signals) names.insert(recorded.name);
  return names;
}

/// Returns the unit in the text of a number, "mm" of "5 mm"; empty for an SI unit or a pure number.
std::string written_unit(const std::string& text) {
  const std::size_t at = text.find_first_not_of("+-.0123456789eE \t");
  if (at == std::string::npos || !unit::parse_quantity(text)) return "";
  const std::string name = text.substr(at);
  const auto unit = unit::parse_unit(name);
  const bool is_other = unit && (unit->scale != 1.0L || unit->offset != 0.0L);
  return is_other ? name : "";
}

/// Writes the numeric bounds of a parameter in SI. An excluded bound is written like an included one; the
/// unit refuses the bound itself.
void limit(std::optional<double>& at_least, std::optional<double>& at_most,
           const std::vector<yaml::Entry>& bounds) {
  for (const yaml::Entry& bound : bounds) {
    const auto quantity = unit::parse_quantity(bound.value.text);
    if (!quantity) continue;
    (bound.key == "above" || bound.key == "at_least" ? at_least : at_most) = quantity->value;
  }
}

/// Returns C++ for the address of the first number of a struct member.
std::string member_place(const std::string& group, const std::string& member) {
  return fmt::format("reinterpret_cast<double*>(&d.{}.{})", group, member);
}

class Collector {
 public:
  Collector(const plan::Plan& plan, const codegen::Tuning& tuning, bool exchange)
      : plan_(plan),
        tuning_(tuning),
        exchange_(exchange),
        groups_(plan, tuning),
        depends_(plan),
        signals_(signal_names(plan.diagram)) {}

  std::vector<Variable> collect() {
    add({.kind = Kind::time,
         .causality = "independent",
         .variability = "continuous",
         .name = "time",
         .about = "time",
         .dimension = unit::parse_unit("s")->dimension},
        plan::SignalSlot{}, {});
    add_parameters();
    add_inputs();
    add_outputs();
    add_recorded();
    if (exchange_) add_states();
    if (exchange_ && plan_.crossing_count > 0) add_indicators();
    faults_.throw_if_any();
    return std::move(variables_);
  }

 private:
  void add(Variable variable, const plan::SignalSlot& slot, const diagram::Origin& origin) {
    const auto [known, is_new] = names_.emplace(variable.name, Named{variables_.size(), slot.offset});
    if (is_new) return variables_.push_back(std::move(variable));
    if (slot.offset != 0 && known->second.offset == slot.offset) return;  // the same signal again
    faults_.add(plan_.diagram.fault(
        origin, "record",
        fmt::format("'{}' would have the name of another variable of the unit, {}; give it another name",
                    variable.name, variables_[known->second.place].about)));
  }

  void add_parameters() {
    for (std::size_t i = 0; i < tuning_.parameters.size(); ++i) {
      const auto d = static_cast<std::size_t>(tuning_.parameters[i]);
      const diagram::DiagramParameter& parameter = plan_.diagram.parameters[d];
      const codegen::GroupMember& member = groups_.parameters.members[i];
      const bool is_signal = signals_.contains(parameter.name);
      Variable variable{.kind = Kind::parameter,
                        .causality = "parameter",
                        .variability = "tunable",
                        .name = (is_signal ? "parameter." : "") + parameter.name,
                        .about = parameter.doc,
                        .dimension = parameter.dimension,
                        .shown_in = written_unit(parameter.text),
                        .sizes = member.sizes,
                        .start = member.initial,
                        .place = member_place("parameters", member.name)};
      limit(variable.at_least, variable.at_most, plan_.diagram.bindings->definitions[d].bounds);
      add(std::move(variable), {}, {});
    }
  }

  void add_inputs() {
    const run::Executor start(plan_);
    for (std::size_t i = 0; i < plan_.diagram.inputs.size(); ++i) {
      const diagram::DiagramInput& input = plan_.diagram.inputs[i];
      const auto block = static_cast<std::size_t>(input.block);
      const plan::SignalSlot& slot = plan_.blocks[block].outputs.front();
      Variable variable = signal(Kind::input, input.name, input.doc, {input.block, 0, -1}, slot);
      variable.causality = "input";
      variable.about = input.doc;
      variable.variability = "continuous";
      variable.place = member_place("inputs", groups_.inputs.members[i].name);
      variable.block = input.block;
      for (Index k = 0; k < slot.size; ++k)  // Row-major start values.
        variable.start.push_back(
            start.values()[slot.offset +
                           static_cast<std::size_t>(k % slot.columns * slot.rows() + k / slot.columns)]);
      add(std::move(variable), slot, plan_.diagram.blocks[block].origin);
    }
  }

  void add_outputs() {
    for (std::size_t i = 0; i < plan_.diagram.outputs.size(); ++i) {
      const diagram::DiagramOutput& output = plan_.diagram.outputs[i];
      Variable variable =
          signal(Kind::output, output.name, output.doc, output.signal, plan_.slot(output.signal));
      variable.place = member_place("outputs", groups_.outputs.members[i].name);
      add(std::move(variable), plan_.slot(output.signal), output.origin);
    }
  }

  void add_recorded() {
    for (const diagram::RecordRequest& request : plan_.diagram.records)
      for (const diagram::RecordedSignal& recorded : request.signals) {
        if (plan_.slot(recorded.signal).size == 0) continue;  // FMI has no empty arrays
        Variable variable =
            signal(Kind::output, recorded.name, "", recorded.signal, plan_.slot(recorded.signal));
        variable.place = member_place("recorded", codegen::recorded_member(recorded));
        add(std::move(variable), plan_.slot(recorded.signal), recorded.origin);
      }
  }

  /// Returns the common attributes of a signal, by default as an output.
  Variable signal(Kind kind, const std::string& name, const std::string& doc, const diagram::SignalRef& of,
                  const plan::SignalSlot& slot) {
    const auto block = static_cast<std::size_t>(of.block);
    Variable variable{.kind = kind,
                      .causality = "output",
                      .name = name,
                      .about = doc.empty() ? about(of) : doc,
                      .dimension = plan_.dimension(of)};
    const plan::Rate::Kind rate = plan_.blocks[block].rate.kind;
    // In model exchange discrete blocks sample only continuous inputs, so their signals are continuous.
    const bool continuous =
        rate == plan::Rate::Kind::continuous || (exchange_ && rate == plan::Rate::Kind::discrete);
    variable.variability = continuous ? "continuous" : "discrete";
    if (slot.columns > 1) {
      variable.sizes = {slot.rows(), slot.columns};
      variable.rows = static_cast<int>(slot.rows());
    } else if (slot.size != 1) {
      variable.sizes = {slot.size};
    }
    if (kind == Kind::output) variable.depends_on = depends_.of(of);
    return variable;
  }
  std::string about(const diagram::SignalRef& of) const {
    const BlockType& type = plan_.diagram.blocks[static_cast<std::size_t>(of.block)].type();
    return of.output >= 0 ? type.outputs[static_cast<std::size_t>(of.output)].doc
                          : type.states[static_cast<std::size_t>(of.state)].doc;
  }

  void add_states() {
    for (std::size_t b = 0; b < plan_.blocks.size(); ++b)
      for (std::size_t s = 0; s < plan_.blocks[b].states.size(); ++s) {
        const plan::SignalSlot& slot = plan_.blocks[b].states[s];
        const bool continuous = slot.offset >= plan_.layout.states && slot.offset < plan_.layout.derivatives;
        if (continuous && slot.size > 0)
          states_[slot.offset] = {static_cast<int>(b), -1, static_cast<int>(s)};
      }
    for (const auto& [offset, state] : states_) add_state(state);  // in the order of the solver's states
  }

  void add_state(const diagram::SignalRef& state) {
    const diagram::DiagramBlock& block = plan_.diagram.blocks[static_cast<std::size_t>(state.block)];
    const StateSpec& spec = block.type().states[static_cast<std::size_t>(state.state)];
    const plan::SignalSlot& slot = plan_.slot(state);
    const std::size_t place = output_in(slot);
    if (place == variables_.size()) {
      Variable variable = signal(Kind::state, free_name(block.name + "." + spec.name), spec.doc, state, slot);
      variable.causality = "local";
      as_list(variable);
      add(std::move(variable), slot, block.origin);
    }
    variables_[place].kind = Kind::state;
    variables_[place].variability = "continuous";
    variables_[place].place = fmt::format("(d.continuous_states() + {})", slot.offset - plan_.layout.states);
    variables_[place].block = state.block;
    add_slope(state, place);
  }

  /// Returns the index of the first output that shares the memory of `slot`; the size of the list if there is
  /// none.
  std::size_t output_in(const plan::SignalSlot& slot) const {
    std::size_t first = variables_.size();
    for (const auto& [name, named] : names_) {
      const Variable& variable = variables_[named.place];
      const bool same = named.offset == slot.offset && variable.kind == Kind::output && slot.columns == 1 &&
                        variable.count() == static_cast<std::size_t>(slot.size);
      if (same) first = std::min(first, named.place);
    }
    return first;
  }

  void add_slope(const diagram::SignalRef& state, std::size_t place) {
    const diagram::DiagramBlock& block = plan_.diagram.blocks[static_cast<std::size_t>(state.block)];
    const std::string of = variables_[place].name;
    const plan::SignalSlot& slot = plan_.slot(state);
    Variable slope = signal(Kind::slope, free_name("der(" + of + ")"), "derivative of " + of, state, slot);
    slope.causality = "local";
    slope.variability = "continuous";
    as_list(slope);
    if (slope.dimension) slope.dimension = *slope.dimension / unit::parse_unit("s")->dimension;
    slope.place = fmt::format("(d.slopes() + {})", slot.offset - plan_.layout.states);
    slope.derivative_of = static_cast<int>(place);
    slope.depends_on = depends_.of_slopes(state.block);
    add(std::move(slope), {}, block.origin);
  }

  /// Reshapes a matrix to a list, in the order of the solver's states.
  static void as_list(Variable& variable) {
    if (variable.sizes.size() == 2) variable.sizes = {static_cast<Index>(variable.count())};
    variable.rows = 1;
  }

  void add_indicators() {
    Variable variable{.kind = Kind::indicator,
                      .causality = "local",
                      .variability = "continuous",
                      .name = free_name("event_indicators"),
                      .about = "numbers that change their sign at events"};
    if (plan_.crossing_count != 1) variable.sizes = {static_cast<Index>(plan_.crossing_count)};
    add(std::move(variable), {}, {});
  }

  std::string free_name(std::string name) const {
    while (names_.contains(name)) name += "_";
    return name;
  }

  struct Named {
    std::size_t place, offset;
  };

  const plan::Plan& plan_;
  const codegen::Tuning& tuning_;
  const bool exchange_;
  const codegen::Groups groups_;
  Dependencies depends_;
  const std::set<std::string> signals_;
  std::vector<Variable> variables_;
  std::map<std::string, Named> names_;
  std::map<std::size_t, diagram::SignalRef> states_;
  yaml::Faults faults_;
};

}  // namespace

std::size_t Variable::count() const {
  return static_cast<std::size_t>(std::accumulate(sizes.begin(), sizes.end(), Index{1}, std::multiplies<>()));
}

std::vector<Variable> variables_of(const plan::Plan& plan, const codegen::Tuning& tuning, bool exchange) {
  return Collector(plan, tuning, exchange).collect();
}

}  // namespace stepwire::fmu
