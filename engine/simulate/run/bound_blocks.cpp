#include "engine/simulate/run/bound_blocks.hpp"

#include <algorithm>
#include <new>

#include "engine/model/signal/diagnostic.hpp"

namespace stepwire::run {

namespace {

constexpr std::align_val_t block_alignment{64};

/// Writes one number to all elements, or one to each.
void write(const plan::SignalSlot& slot, const Eigen::VectorXd& value, double* values) {
  for (Eigen::Index k = 0; k < slot.size; ++k)
    values[slot.offset + static_cast<std::size_t>(k)] = value[value.size() == 1 ? 0 : k];
}

/// Binds the inputs of a block. The elements of list inputs are stored from `element` on.
void bind_inputs(const BlockType& type, const plan::PlannedBlock& planned, void* block, double* values,
                 Inputs::Element* element) {
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    const auto& slots = planned.inputs[i];
    if (type.inputs[i].list) {
      const Inputs::Element* first = element;
      for (const plan::SignalSlot& slot : slots) *element++ = {values + slot.offset, slot.size};
      type.inputs[i].bind_list(block, first, static_cast<Eigen::Index>(slots.size()));
    } else if (slots.empty()) {
      type.inputs[i].unbind(block);
    } else {
      type.inputs[i].bind(block, values + slots.front().offset, slots.front().size);
    }
  }
}

/// Writes the initial values of a block's states.
void write_states(const plan::Plan& plan, std::size_t index, double* values) {
  const diagram::DiagramBlock& from = plan.diagram.blocks[index];
  const auto& states = plan.blocks[index].states;
  for (std::size_t s = 0; s < states.size(); ++s)
    std::fill_n(values + states[s].offset, states[s].size, from.type().states[s].initial);
  for (const diagram::InitialValue& initial : from.initial)
    write(states[static_cast<std::size_t>(initial.state)], initial.value, values);
}

}  // namespace

void BoundBlocks::FreeMemory::operator()(std::byte* memory) const {
  ::operator delete(memory, block_alignment);
}

BoundBlocks::BoundBlocks(const plan::Plan& plan, double* values)
    : plan_(plan),
      values_(values),
      memory_(static_cast<std::byte*>(::operator new(plan.block_bytes + 1, block_alignment))),
      constants_(plan.constants) {
  for (const int block : plan.memory_order) {
    const diagram::DiagramBlock& from = plan.diagram.blocks[static_cast<std::size_t>(block)];
    from.type().copy(memory(static_cast<std::size_t>(block)), from.block.get());
  }
  std::size_t elements = 0;
  for (const plan::PlannedBlock& block : plan.blocks) {
    first_list_element_.push_back(elements);
    for (const auto& slots : block.inputs) elements += slots.size();
  }
  list_elements_.resize(elements);
  for (const int block : plan.memory_order) bind(static_cast<std::size_t>(block));
}

BoundBlocks::~BoundBlocks() {
  for (const int block : plan_.memory_order) {
    const auto index = static_cast<std::size_t>(block);
    plan_.diagram.blocks[index].type().destroy(memory(index));
  }
}

void BoundBlocks::bind(std::size_t index) {
  const BlockType& type = plan_.diagram.blocks[index].type();
  const plan::PlannedBlock& planned = plan_.blocks[index];
  void* block = memory(index);
  bind_inputs(type, planned, block, values_, list_elements_.data() + first_list_element_[index]);
  for (std::size_t o = 0; o < type.outputs.size(); ++o)
    type.outputs[o].bind(block, values_ + planned.outputs[o].offset, planned.outputs[o].size);
  for (std::size_t s = 0; s < type.states.size(); ++s)
    type.states[s].bind(block, values_ + planned.states[s].offset, values_ + planned.derivatives[s].offset,
                        planned.states[s].size);
  for (std::size_t n = 0; n < type.diagnostics.size(); ++n)
    type.diagnostics[n].bind(block, values_ + planned.diagnostics[n].offset);
  for (const ClockSpec& clock : type.clocks)
    if (clock.bind_time) clock.bind_time(block, values_ + plan::Layout::time);
}

void BoundBlocks::restart() {
  std::fill_n(values_, plan_.layout.size, 0.0);
  values_[plan::Layout::timed] = plan::Layout::never;
  write_constants();
  std::fill_n(values_ + plan_.layout.diagnostics, plan_.layout.diagnostic_count, Diagnostic::never);
  for (const int block : plan_.memory_order) write_states(plan_, static_cast<std::size_t>(block), values_);
  for (const auto& [slot, value] : initial_) write(slot, value, values_);
  for (const int block : plan_.memory_order)
    if (plan_.diagram.blocks[static_cast<std::size_t>(block)].type().start)
      start(static_cast<std::size_t>(block));
}

void BoundBlocks::write_constants() {
  std::ranges::copy(constants_, values_ + plan_.layout.constants);
}

void BoundBlocks::write_input(std::size_t input, const double* numbers) {
  const auto block = static_cast<std::size_t>(plan_.diagram.inputs[input].block);
  const plan::SignalSlot& slot = plan_.blocks[block].outputs.front();
  std::copy_n(numbers, slot.size, values_ + slot.offset);
}

void BoundBlocks::apply(plan::PlanChange& change) {
  const std::vector<double> before(values_, values_ + plan_.layout.size);  // start() of a block writes to it
  for (plan::RebuiltBlock& rebuilt : change.blocks) replace(rebuilt);
  std::ranges::copy(before, values_);
  for (const auto& [slot, value] : change.constants) set_constant(slot, value);
  for (const auto& [slot, value] : change.initial) set_initial(slot, value);
}

void BoundBlocks::replace(plan::RebuiltBlock& rebuilt) {
  const BlockType& type = rebuilt.made.type();
  void* block = memory(rebuilt.block);
  type.destroy(block);
  type.copy(block, rebuilt.made.get());
  bind(rebuilt.block);
  if (type.start) type.start(block);
}

void BoundBlocks::set_constant(const plan::SignalSlot& slot, const Eigen::VectorXd& value) {
  write({slot.offset - plan_.layout.constants, slot.size}, value, constants_.data());
}

/// Sets an initial value; for a state that a guard resets, also the constant that holds it.
void BoundBlocks::set_initial(const plan::SignalSlot& state, const Eigen::VectorXd& value) {
  for (const plan::PlannedBlock& block : plan_.blocks)
    for (std::size_t s = 0; s < block.initial.size(); ++s)
      if (block.states[s].offset == state.offset) set_constant({block.initial[s].offset, state.size}, value);
  std::erase_if(initial_, [at = state.offset](const auto& known) { return known.first.offset == at; });
  initial_.emplace_back(state, value);
}

void BoundBlocks::put_numbers(diagram::Diagram& diagram) const {
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

}  // namespace stepwire::run
