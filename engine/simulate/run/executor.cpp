// More than 300 lines with its header: what steps, sets and explains a run shares its workspace and blocks,
// which nobody else may change.
#include "engine/simulate/run/executor.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>

#include "engine/model/plan/active_pieces.hpp"
#include "engine/model/signal/diagnostic.hpp"
#include "engine/simulate/run/solver_of.hpp"
#include "engine/simulate/run/whole_step.hpp"

namespace stepwire::run {

namespace {

constexpr std::align_val_t block_alignment{64};

/// One number for all elements, or one for each.
void write(const plan::SignalSlot& slot, const Eigen::VectorXd& value, double* values) {
  for (Eigen::Index k = 0; k < slot.size; ++k)
    values[slot.offset + static_cast<std::size_t>(k)] = value[value.size() == 1 ? 0 : k];
}

/// Elements of lists are put from `element` on.
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

/// The values with which the states of a block begin.
void write_states(const plan::Plan& plan, std::size_t index, double* values) {
  const diagram::DiagramBlock& from = plan.diagram.blocks[index];
  const auto& states = plan.blocks[index].states;
  for (std::size_t s = 0; s < states.size(); ++s)
    std::fill_n(values + states[s].offset, states[s].size, from.type().states[s].initial);
  for (const diagram::InitialValue& initial : from.initial)
    write(states[static_cast<std::size_t>(initial.state)], initial.value, values);
}

}  // namespace

/// The continuous part of the diagram at a solver's stage.
class Executor::Equations : public solve::System {
 public:
  explicit Equations(Executor& simulation) : simulation_(simulation) {
    const plan::Layout& layout = simulation.plan_.layout;
    double* values = simulation.workspace_.values.data();
    time = values + plan::Layout::time;
    x = values + layout.states;
    dot = values + layout.derivatives;
    count = layout.state_count;
    report = {values + layout.report, simulation.plan_.diagram.tolerance};
    moving = {{0, count}};
    moving.reserve(simulation.states_.size() + 1);
  }
  /// Leaves out what is off.
  void find_moving() {
    const std::size_t first = simulation_.plan_.layout.states;
    moving.clear();
    for (const Piece& piece : simulation_.states_)
      if (!piece.active || *piece.active != 0.0) moving.push_back({piece.first - first, piece.end - first});
    if (moving.empty()) moving.push_back({0, 0});
  }
  void evaluate() override {
    simulation_.follow_time();
    simulation_.run(simulation_.stage_);
    simulation_.run(simulation_.derivatives_);
  }

 private:
  Executor& simulation_;
};

void Executor::FreeBlocks::operator()(std::byte* memory) const {
  ::operator delete(memory, block_alignment);
}

Executor::Executor(const plan::Plan& plan)
    : plan_(plan),
      solver_(solver_of(plan)),
      blocks_(static_cast<std::byte*>(::operator new(plan.block_bytes + 1, block_alignment))),
      once_(plan, plan.once, blocks_.get()),
      timed_(plan, plan.timed, blocks_.get()),
      outputs_(plan, plan.outputs, blocks_.get()),
      stage_(plan, plan.stage, blocks_.get()),
      derivatives_(plan, plan.derivatives, blocks_.get()),
      updates_(plan, plan.updates, blocks_.get()),
      ahead_(plan, plan.ahead, blocks_.get()),
      rest_(plan, plan.rest, blocks_.get()),
      crossing_outputs_(plan, plan.crossing_outputs, blocks_.get()),
      crossing_starts_(plan, plan.crossing_starts, blocks_.get()),
      event_befores_(plan, plan.event_befores, blocks_.get()),
      event_outputs_(plan, plan.event_outputs, blocks_.get()),
      event_updates_(plan, plan.event_updates, blocks_.get()),
      event_scratch_(solve::EventTask::scratch_size(plan.layout.state_count, plan.crossing_count,
                                                    plan.layout.diagnostics - plan.layout.signals)) {
  workspace_.values.assign(plan.layout.size, 0.0);
  constants_ = plan.constants;
  due_.assign(plan.periods.size(), 1);
  for (int block : plan.memory_order) {
    const auto index = static_cast<std::size_t>(block);
    const diagram::DiagramBlock& from = plan.diagram.blocks[index];
    from.type().copy(memory(index), from.block.get());
  }
  const plan::Layout& layout = plan.layout;
  checked_ = pieces_of(layout.signals, layout.derivatives + layout.state_count);
  states_ = pieces_of(layout.states, layout.derivatives);
  equations_ = std::make_unique<Equations>(*this);
  if (!plan.guards.empty()) {
    guards_.emplace(plan, workspace_.values.data(),
                    [this](std::size_t block) { plan_.diagram.blocks[block].type().start(memory(block)); });
    for (Table* table :
         {&timed_, &outputs_, &stage_, &derivatives_, &updates_, &ahead_, &rest_, &crossing_outputs_,
          &crossing_starts_, &event_befores_, &event_outputs_, &event_updates_})
      table->add_gates(workspace_.values.data());
  }
  bind();
  find_looks();
  reset();
}

Executor::~Executor() {
  for (int block : plan_.memory_order) {
    const auto index = static_cast<std::size_t>(block);
    plan_.diagram.blocks[index].type().destroy(memory(index));
  }
}

void Executor::bind() {
  std::size_t elements = 0;
  for (const plan::PlannedBlock& block : plan_.blocks) {
    first_list_element_.push_back(elements);
    for (const auto& slots : block.inputs) elements += slots.size();
  }
  list_elements_.resize(elements);
  for (int block : plan_.memory_order) bind_block(static_cast<std::size_t>(block));
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const auto& specs = plan_.diagram.blocks[b].type().diagnostics;
    for (std::size_t n = 0; n < specs.size(); ++n)
      if (specs[n].ends_run) ending_diagnostics_.push_back(plan_.blocks[b].diagnostics[n].offset);
  }
}

void Executor::bind_block(std::size_t index) {
  const BlockType& type = plan_.diagram.blocks[index].type();
  const plan::PlannedBlock& planned = plan_.blocks[index];
  double* values = workspace_.values.data();
  void* block = memory(index);
  bind_inputs(type, planned, block, values, list_elements_.data() + first_list_element_[index]);
  for (std::size_t o = 0; o < type.outputs.size(); ++o)
    type.outputs[o].bind(block, values + planned.outputs[o].offset, planned.outputs[o].size);
  for (std::size_t s = 0; s < type.states.size(); ++s)
    type.states[s].bind(block, values + planned.states[s].offset, values + planned.derivatives[s].offset,
                        planned.states[s].size);
  for (std::size_t n = 0; n < type.diagnostics.size(); ++n)
    type.diagnostics[n].bind(block, values + planned.diagnostics[n].offset);
  for (const ClockSpec& clock : type.clocks)
    if (clock.bind_time) clock.bind_time(block, values + plan::Layout::time);
}

void Executor::reset() {
  workspace_.tick = 0;
  knows_end_ = false;
  healthy_ = true;
  auto& values = workspace_.values;
  std::fill(values.begin(), values.end(), 0.0);
  values[plan::Layout::timed] = plan::Layout::never;
  write_constants();
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(plan_.layout.diagnostics),
              plan_.layout.diagnostic_count, Diagnostic::never);
  for (const int block : plan_.memory_order)
    write_states(plan_, static_cast<std::size_t>(block), values.data());
  for (const auto& [slot, value] : initial_) write(slot, value, values.data());
  for (int block : plan_.memory_order) {
    const auto index = static_cast<std::size_t>(block);
    const BlockType& type = plan_.diagram.blocks[index].type();
    if (type.start) type.start(memory(index));
  }
  compute_once();
}

void Executor::write_constants() {
  std::copy(constants_.begin(), constants_.end(),
            workspace_.values.begin() + static_cast<std::ptrdiff_t>(plan_.layout.constants));
}

void Executor::compute_once() {
  run_range(once_, 0, once_.calls.size());
}

void Executor::restore(const Workspace& workspace) {
  // The blocks point into these numbers, so they are written in place.
  std::copy(workspace.values.begin(), workspace.values.end(), workspace_.values.begin());
  workspace_.tick = workspace.tick;
  healthy_ = true;
  follow_values();
}

void Executor::write_input(std::size_t input, const double* numbers) {
  const auto block = static_cast<std::size_t>(plan_.diagram.inputs[input].block);
  const plan::SignalSlot& slot = plan_.blocks[block].outputs.front();
  std::copy_n(numbers, slot.size, workspace_.values.begin() + static_cast<std::ptrdiff_t>(slot.offset));
}

void Executor::find_due() {
  for (std::size_t i = 1; i < due_.size(); ++i) due_[i] = workspace_.tick % plan_.periods[i] == 0;
}

void Executor::evaluate() {
  if (has_stopped()) return;
  if (code_) {
    code_->functions.evaluate(workspace_.values.data(), numbers_->data(), workspace_.tick);
  } else {
    workspace_.values[plan::Layout::time] = plan_.time_of(workspace_.tick);
    follow_time();
    find_due();
    run_due(is_ahead() ? rest_ : outputs_);
    forget_ahead();
  }
  look_at_outputs();
}

void Executor::advance() {
  if (has_stopped()) {
    ++workspace_.tick;
    return;
  }
  if (code_) {
    code_->functions.advance(workspace_.values.data(), numbers_->data(), workspace_.tick);
  } else {
    take_step();
  }
  look_at_step();
  ++workspace_.tick;
}

void Executor::look_at_step() {
  if (!ending_diagnostics_.empty() && diagnostic_ends_run()) healthy_ = false;
  if (workspace_.values[plan_.layout.report] != solve::StepReport::fine || !loops_solved()) healthy_ = false;
  if (plan_.splits_steps() && workspace_.values[plan_.layout.events + solve::EventReport::end] != 0.0)
    healthy_ = false;
}

void Executor::take_step() {
  run_due(updates_);
  if (guards_ && solver_) guards_->keep();
  if (plan_.updates_continuous) run(stage_);
  if (plan_.splits_steps()) return take_located_step();
  if (!solver_) return;
  run(derivatives_);
  step_states(whole_step(plan_, workspace_.tick));
}

std::vector<Executor::Piece> Executor::pieces_of(std::size_t first, std::size_t end) const {
  std::vector<Piece> pieces;
  for (const plan::ActivePiece& piece : plan::active_pieces(plan_, first, end))
    pieces.push_back({piece.first, piece.end, piece.active < 0 ? nullptr : values() + piece.active});
  return pieces;
}

const std::vector<solve::StatePiece>& Executor::moving_states() const {
  return equations_->moving;
}

void Executor::step_states(const solve::TimeStep& step) {
  if (guards_) equations_->find_moving();
  solver_->advance(*equations_, step);
}

}  // namespace stepwire::run
