#include "engine/app/python/python_block.hpp"

#include <algorithm>

#include "engine/app/python/instance.hpp"
#include "engine/app/python/lock.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire::python {

namespace {

constexpr std::size_t output_method = 0, slope_method = 1, update_method = 2;

const Method& method_of(const PythonClass& of, std::size_t method) {
  return method == output_method  ? of.output_method
         : method == slope_method ? of.slope_method
                                  : of.update_method;
}

Given given_to(const PythonBlock& block, const Argument& argument) {
  switch (argument.source) {
    case Source::input:
      return {block.inputs[argument.index].data(), block.inputs[argument.index].size(),
              block.of->inputs[argument.index].rows};
    case Source::state:
      return {block.states[argument.index].data(), block.states[argument.index].size(),
              block.of->states[argument.index].rows};
    case Source::memory:
      return {block.memory[argument.index].data(), block.memory[argument.index].size(),
              block.of->memory[argument.index].rows};
    case Source::time:
      return {&block.now, 1};
    default:
      return {&block.between, 1};
  }
}

}  // namespace

PythonBlock::PythonBlock(const PythonBlock& other)
    : of(other.of),
      inputs(other.inputs),
      results(other.results),
      states(other.states),
      memory(other.memory),
      values(other.values),
      failed(other.failed),
      t(other.t),
      period(other.period) {}

void PythonBlock::outputs() {
  call(output_method);
}

void PythonBlock::derivatives() {
  call(slope_method);
}

void PythonBlock::update() {
  call(update_method);
}

void PythonBlock::start() {
  why.clear();
  const Lock lock;
  instance = Instance::make(*of, values.data());
  if (!instance) return fail();
  for (const std::size_t method : {output_method, slope_method, update_method}) connect(method);
}

void PythonBlock::configure(Configure&) {
  const Lock lock;
  if (Instance::make(*of, values.data())) return;
  Raised raised;
  raised.keep();
  throw ParameterRefused("__init__", text_of(raised.latest()));
}

void PythonBlock::connect(std::size_t method) {
  std::vector<Given> given;
  for (const Argument& argument : method_of(*of, method).arguments)
    given.push_back(given_to(*this, argument));
  std::vector<Target> targets;
  if (method == output_method)
    for (std::size_t i = 0; i < of->outputs.size(); ++i)
      targets.push_back(
          {results[i].data(), results[i].size(), of->outputs[i].name.c_str(), of->outputs[i].rows});
  if (method == slope_method)
    for (std::size_t i = 0; i < of->states.size(); ++i)
      targets.push_back({states[i].derivative.data(), states[i].derivative.size(), of->states[i].name.c_str(),
                         of->states[i].rows});
  if (method == update_method)
    for (std::size_t i = 0; i < of->memory.size(); ++i)
      targets.push_back({memory[i].data(), memory[i].size(), of->memory[i].name.c_str(), of->memory[i].rows});
  instance->connect(method, std::move(given), std::move(targets));
}

/// Calls a method of the object. After the first failure it calls nothing, and the run ends at this tick.
void PythonBlock::call(std::size_t method) {
  if (!why.empty()) return;
  now = t;
  between = period;
  const Lock lock;
  if (!instance->call(method)) fail();
}

void PythonBlock::fail() {
  of->raised->keep();
  why = text_of(of->raised->latest());
  failed.raise(t);
}

void PythonBlock::declare(Declare<PythonBlock>& is) {
  is.block("Python", {.doc = "A class of Python's.",
                      .not_real_time = "its methods are Python's, of whose steps nothing bounds the time"});
  is.diagnostic<&PythonBlock::failed, [](const PythonBlock& block) { return block.why; }>(
      {.doc = "a method raised an exception", .ends_run = true});
  is.clock<&PythonBlock::t>();
  is.clock<&PythonBlock::period>();
}

}  // namespace stepwire::python
