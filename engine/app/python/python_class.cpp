// Converts a Python class to a block type. Ports are bound by function pointers, so one function is
// instantiated for each port index.
#include "engine/app/python/python_class.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "engine/app/python/python_block.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire::python {

namespace {

using All = std::make_index_sequence<PythonBlock::most>;

PythonBlock& block_of(void* block) {
  return *static_cast<PythonBlock*>(block);
}

template <std::size_t... k>
constexpr auto input_binders(std::index_sequence<k...>) {
  return std::array<decltype(InputSpec::bind), sizeof...(k)>{
      [](void* block, const double* data, Eigen::Index size) {
        block_of(block).inputs[k].bind(data, size);
      }...};
}

template <std::size_t... k>
constexpr auto output_binders(std::index_sequence<k...>) {
  return std::array<decltype(OutputSpec::bind), sizeof...(k)>{
      [](void* block, double* data, Eigen::Index size) { block_of(block).results[k].bind(data, size); }...};
}

template <std::size_t... k>
constexpr auto state_binders(std::index_sequence<k...>) {
  return std::array<decltype(StateSpec::bind), sizeof...(k)>{
      [](void* block, double* data, double* derivative, Eigen::Index size) {
        block_of(block).states[k].bind(data, size);
        block_of(block).states[k].derivative.bind(derivative, size);
      }...};
}

template <std::size_t... k>
constexpr auto memory_binders(std::index_sequence<k...>) {
  return std::array<decltype(StateSpec::bind), sizeof...(k)>{
      [](void* block, double* data, double*, Eigen::Index size) {
        block_of(block).memory[k].bind(data, size);
      }...};
}

template <std::size_t... k>
constexpr auto setters(std::index_sequence<k...>) {
  return std::array<decltype(ParameterSpec::set), sizeof...(k)>{
      [](void* block, const Value& value) { block_of(block).values[k] = value; }...};
}

template <std::size_t... k>
constexpr auto getters(std::index_sequence<k...>) {
  return std::array<decltype(ParameterSpec::get), sizeof...(k)>{
      [](const void* block) { return static_cast<const PythonBlock*>(block)->values[k]; }...};
}

void require_few(const std::string& name, std::size_t count, const char* what) {
  if (count > PythonBlock::most)
    throw std::invalid_argument(
        fmt::format("{} has {} {}; a block has {} at most", name, count, what, PythonBlock::most));
}

void require_unit(const std::string& subject, const std::string& unit) {
  if (unit == "*" || unit.find('\'') != unit.npos || unit::parse_unit(unit)) return;
  throw std::invalid_argument(
      fmt::format("{}: '{}' is no unit; write e.g. N, m/s, or 1 for none", subject, unit));
}

void require_units(const PythonClass& of) {
  for (const auto* ports : {&of.inputs, &of.outputs, &of.states, &of.memory})
    for (const PythonClass::Port& port : *ports) require_unit(of.name + "." + port.name, port.unit);
  for (const PythonClass::Parameter& parameter : of.parameters)
    require_unit(of.name + "." + parameter.name, parameter.unit);
}

ParameterKind kind_of(const Value& value) {
  if (value.text()) return ParameterKind::text;
  if (std::holds_alternative<bool>(value.content)) return ParameterKind::flag;
  return std::holds_alternative<Eigen::VectorXd>(value.content) ? ParameterKind::vector
                                                                : ParameterKind::number;
}

void add_parameters(BlockType& type, const PythonClass& of) {
  static constexpr auto set = setters(All());
  static constexpr auto get = getters(All());
  for (std::size_t i = 0; i < of.parameters.size(); ++i) {
    const PythonClass::Parameter& parameter = of.parameters[i];
    ParameterSpec spec{parameter.name, kind_of(parameter.value), parameter.unit, "", parameter.doc, {}, {}};
    spec.required = parameter.required;
    spec.set = set[i];
    spec.get = get[i];
    type.parameters.push_back(std::move(spec));
  }
}

void add_ports(BlockType& type, const PythonClass& of) {
  static constexpr auto bind_input = input_binders(All());
  static constexpr auto bind_output = output_binders(All());
  for (std::size_t i = 0; i < of.inputs.size(); ++i) {
    const PythonClass::Port& port = of.inputs[i];
    InputSpec spec{port.name, port.unit, port.shape, "", fmt::format("inputs[{}]", i), port.feedthrough};
    spec.bind = bind_input[i];
    spec.unbind = [](void*) {};
    type.inputs.push_back(std::move(spec));
  }
  for (std::size_t i = 0; i < of.outputs.size(); ++i)
    type.outputs.push_back({of.outputs[i].name, of.outputs[i].unit, of.outputs[i].shape, "",
                            fmt::format("results[{}]", i), "", bind_output[i]});
}

void add_states(BlockType& type, const PythonClass& of) {
  static constexpr auto bind_state = state_binders(All());
  static constexpr auto bind_memory = memory_binders(All());
  const auto add = [&](const PythonClass::Port& port, bool continuous, std::size_t i) {
    const std::string member = fmt::format("{}[{}]", continuous ? "states" : "memory", i);
    StateSpec spec{port.name, port.unit, port.shape, "", member, continuous, true, port.initial};
    spec.bind = continuous ? bind_state[i] : bind_memory[i];
    type.states.push_back(std::move(spec));
  };
  for (std::size_t i = 0; i < of.states.size(); ++i) add(of.states[i], true, i);
  for (std::size_t i = 0; i < of.memory.size(); ++i) add(of.memory[i], false, i);
}

bool takes(const Method& method, Source source) {
  for (const Argument& argument : method.arguments)
    if (argument.source == source) return true;
  return false;
}

bool takes(const PythonClass& of, Source source) {
  return takes(of.output_method, source) || takes(of.slope_method, source) || takes(of.update_method, source);
}

Timing timing_of(const PythonClass& of) {
  if (!of.states.empty() || takes(of.output_method, Source::time)) return Timing::continuous;
  return of.update_method.exists ? Timing::discrete : Timing::inherited;
}

void leave_out(BlockType& type, const PythonClass& of) {
  if (!of.output_method.exists) type.run_outputs = {};
  if (!of.slope_method.exists) type.run_derivatives = {};
  if (!of.update_method.exists) type.run_update = {};
  // A clock with a period is refused for blocks without one, for example behind a trigger. So the clock is
  // dropped if no method uses the period.
  if (!takes(of, Source::period))
    std::erase_if(type.clocks, [](const ClockSpec& clock) { return clock.bind_period; });
}

void require_fit(const PythonClass& of) {
  require_few(of.name, of.inputs.size(), "inputs");
  require_few(of.name, of.outputs.size(), "outputs");
  require_few(of.name, std::max(of.states.size(), of.memory.size()), "states");
  require_few(of.name, of.parameters.size(), "parameters");
  require_units(of);
}

/// Returns the block type without ports, states and parameters.
BlockType bare_type(const PythonClass& of) {
  Declare<PythonBlock> is;
  PythonBlock::declare(is);
  BlockType type = is.take();
  type.name = of.name;
  type.doc = of.doc;
  type.declared_at = of.place;
  type.folder = "python";
  type.header.clear();
  type.timing = timing_of(of);
  type.not_generated = "its methods are Python's; a block of C++ can be generated";
  return type;
}

}  // namespace

BlockType type_of(std::shared_ptr<const PythonClass> made) {
  require_fit(*made);
  BlockType type = bare_type(*made);
  add_parameters(type, *made);
  add_ports(type, *made);
  add_states(type, *made);
  leave_out(type, *made);
  type.construct = [made](void* memory) {
    auto* block = ::new (memory) PythonBlock;
    block->of = made;
    for (std::size_t i = 0; i < made->parameters.size(); ++i) block->values[i] = made->parameters[i].value;
  };
  return type;
}

}  // namespace stepwire::python
