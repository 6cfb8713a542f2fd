// Values that are set while a run goes on.
#include "engine/simulate/run/executor.hpp"

#include <algorithm>

namespace stepwire::run {

void Executor::use(const plan::CompiledPlan& code) {
  numbers_.emplace(plan_, code.variable, [this](std::size_t block) { return memory(block); });
  code_ = &code;
  for (const auto& [block, written] : written_) read_numbers(block);
}

std::optional<plan::NumberTable> Executor::numbers(const std::vector<plan::VariableBlock>& variable) const {
  plan::NumberTable numbers(plan_, variable, [this](std::size_t block) { return memory(block); });
  for (const auto& [block, written] : written_)
    if (!numbers.read(block)) return std::nullopt;
  return numbers;
}

void Executor::stand_at(std::int64_t tick, std::span<const double> values, bool after_step) {
  std::ranges::copy(values, workspace_.values.begin());
  workspace_.tick = after_step ? tick + 1 : tick;
  after_step ? look_at_step() : look_at_outputs();
}

void Executor::read_numbers(std::size_t block) {
  if (code_ && !numbers_->read(block)) code_ = nullptr;
}

void Executor::widen(std::vector<plan::VariableBlock>& variable) const {
  stepwire::plan::widen(variable, plan_, [this](std::size_t block) { return memory(block); });
}

const Value& Executor::parameter(std::size_t index) const {
  const Value* set = parameters_ ? parameters_->value(index) : nullptr;
  return set ? *set : plan_.diagram.parameters[index].value;
}

diagram::Diagram Executor::diagram() const {
  diagram::Diagram diagram = plan_.diagram;
  put_values(diagram);
  return diagram;
}

void Executor::put_values(diagram::Diagram& diagram) const {
  for (const auto& [index, written] : written_) {
    const BlockType& type = written.type();
    AnyBlock& block = diagram.blocks[index].block;
    type.destroy(block.get());
    type.copy(block.get(), memory(index));
  }
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const plan::PlannedBlock& planned = plan_.blocks[b];
    for (std::size_t i = 0; i < planned.inputs.size(); ++i)
      for (std::size_t k = 0; k < planned.inputs[i].size(); ++k)
        if (diagram::Source& source = diagram.blocks[b].inputs[i][k]; source.block < 0)
          for (Eigen::Index e = 0; e < source.constant.size(); ++e)
            source.constant[e] = constants_[planned.inputs[i][k].offset - plan_.layout.constants +
                                            static_cast<std::size_t>(e)];
    for (diagram::InitialValue& initial : diagram.blocks[b].initial)
      for (const auto& [slot, value] : initial_)
        if (slot.offset == planned.states[static_cast<std::size_t>(initial.state)].offset)
          initial.value = value;
  }
}

Executor::Setting Executor::set(const std::string& name, const std::string& value) {
  const std::string place = "set " + name + "=" + value;
  return set(diagram::Variation(plan_.diagram, {name}),
             {{{name, diagram::value_of_text(value, place), place}}});
}

Executor::Setting Executor::set(const diagram::Variation& variation,
                                std::span<const diagram::Assignment> values) {
  if (variation.structural()) {
    const auto found = std::ranges::find_if(variation.names(), &diagram::Variation::Name::structural);
    structure_change_ = found->text + ": the diagram's times, records or parts follow from it";
    return Setting::structure_changed;
  }
  if (!parameters_) parameters_.emplace(plan_.diagram);
  const std::vector<diagram::ChangedValue> changed = parameters_->set(variation, values);
  try {
    plan::PlanChange change = plan::change_of(plan_, changed, written_);
    structure_change_ = change.structure;
    if (structure_change_.empty()) apply(change);
  } catch (...) {
    parameters_->undo();
    throw;
  }
  if (!structure_change_.empty()) {
    parameters_->undo();
    return Setting::structure_changed;
  }
  return Setting::done;
}

void Executor::apply(plan::PlanChange& change) {
  const std::vector<double> before = workspace_.values;  // a block's start() writes into them
  for (plan::RebuiltBlock& rebuilt : change.blocks) replace(rebuilt);
  std::copy(before.begin(), before.end(), workspace_.values.begin());
  for (const auto& [slot, value] : change.constants)
    for (Eigen::Index k = 0; k < slot.size; ++k)
      constants_[slot.offset - plan_.layout.constants + static_cast<std::size_t>(k)] =
          value[value.size() == 1 ? 0 : k];
  for (auto& [slot, value] : change.initial) {
    write_initial(slot, value);
    std::erase_if(initial_, [at = slot.offset](const auto& known) { return known.first.offset == at; });
    initial_.emplace_back(slot, std::move(value));
  }
  follow_values();
}

/// Where a guard puts the state back, it has the value among the constants.
void Executor::write_initial(const plan::SignalSlot& state, const Eigen::VectorXd& value) {
  if (!guards_) return;
  for (const plan::PlannedBlock& block : plan_.blocks)
    for (std::size_t s = 0; s < block.initial.size(); ++s)
      if (block.states[s].offset == state.offset)
        for (Eigen::Index k = 0; k < state.size; ++k)
          constants_[block.initial[s].offset - plan_.layout.constants + static_cast<std::size_t>(k)] =
              value[value.size() == 1 ? 0 : k];
}

void Executor::replace(plan::RebuiltBlock& rebuilt) {
  const BlockType& type = rebuilt.made.type();
  void* block = memory(rebuilt.block);
  type.destroy(block);
  type.copy(block, rebuilt.made.get());
  bind_block(rebuilt.block);
  if (type.start) type.start(block);
  read_numbers(rebuilt.block);
  written_.insert_or_assign(rebuilt.block, std::move(rebuilt.written));
}

void Executor::follow_values() {
  write_constants();
  compute_once();
  workspace_.values[plan::Layout::timed] = plan::Layout::never;
  forget_ahead();
  knows_end_ = false;
}

}  // namespace stepwire::run
