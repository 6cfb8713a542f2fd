#include "engine/analyse/linear/working_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/simulate/run/drive.hpp"

namespace stepwire::linear {
namespace {

[[noreturn]] void refuse(const yaml::Place& place, const std::string& why) {
  throw yaml::Error(yaml::Fault{place, "at", why, {}});
}

[[noreturn]] void refuse(const yaml::Place& place, double time, const std::string& why) {
  refuse(place, fmt::format("{} s is not within the run; {}", time, why));
}

/// Runs up to a time [s]. Throws Error with `place` if it is no multiple of `base_ticks`, and if the run is
/// shorter or fails.
std::unique_ptr<run::Executor> run_up_to(const plan::Plan& plan, double time, std::int64_t base_ticks,
                                         const yaml::Place& place) {
  if (!(time >= 0.0 && time <= plan.diagram.stop))
    refuse(
        place, time,
        fmt::format("it goes from 0 to {} s; give a time within it, or a later 'stop'", plan.diagram.stop));
  if (const std::string fault = between_ticks(time, plan.diagram, base_ticks); !fault.empty())
    refuse(place, fault);
  auto run = std::make_unique<run::Executor>(plan);
  std::vector<record::Recorder> nothing_recorded;
  run::Drive drive(*run, nothing_recorded);
  drive.judges_steps = false;
  drive.until = static_cast<std::int64_t>(std::llround(time / plan.diagram.step));
  if (drive.run() == run::Drive::End::paused) return run;
  if (const auto fault = run->fault()) throw yaml::Error(fault->fault);
  refuse(place, time,
         fmt::format("'stop_when'{} ends it at {:.12g} s; give an earlier time",
                     run->has_stopped() ? " or a block" : "", run->time()));
}

/// Throws Error with all blocks on the way that a state-space analysis cannot describe.
void require_linear(const plan::Plan& plan, const Paths& paths) {
  yaml::Faults faults;
  for (std::size_t b = 0; b < plan.diagram.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    if (const BlockType& type = block.type(); !type.delayed_by.empty() && paths.on_way(b))
      faults.add(plan.diagram.fault(
          block.origin, block.name,
          fmt::format(
              "{} cannot be linearised here: beside blocks that act at ticks it has no finite number of "
              "states; put a Delay of whole sample times in its place, or a TransferFunction that "
              "approximates it",
              type.name)));
  }
  faults.throw_if_any();
}

/// True for a whole number from 0 to rows - 1.
bool is_index(double value, std::size_t rows) {
  return value >= 0.0 && value < static_cast<double>(rows) && value == std::floor(value);
}

}  // namespace

WorkingPoint::WorkingPoint(const PreparedDiagram& diagram, const Request& request)
    : diagram_(diagram),
      paths_(find_paths(diagram.plan, diagram.input_blocks, diagram.output_blocks, diagram.cut)),
      sampled_(paths_.sampled()) {
  if (request.whole) {
    paths_.from_inputs.assign(diagram.plan.blocks.size(), 1);
    paths_.to_outputs = paths_.from_inputs;
    sampled_ = paths_.sampled();
  }
  if (diagram.delays.empty()) require_linear(diagram.plan, paths_);
  if (sampled_) base_ticks_ = base_period(diagram.plan, paths_);
  run_to(request.time, request);
  cut();
  if (!sampled_) {
    run_ = std::make_unique<run::Executor>(diagram.slopes);
    point_.values.resize(run_->workspace().values.size());
  }
  respond();
  if (sampled_) later_.assign(run_->values(), run_->values() + point_.values.size());
  find_states();
}

double WorkingPoint::number(std::size_t offset) {
  run_->restore(point_);
  run_->evaluate();
  return run_->values()[offset];
}

void WorkingPoint::run_to(double time, const Request& request) {
  const bool has_from = request.at.file.empty() && !request.from.empty();
  const yaml::Place& place = has_from ? request.from.front().place : request.at;
  run_ = run_up_to(diagram_.plan, time, base_ticks_, place);
  point_ = run_->workspace();
  leave_start();
  run_->restore(point_);
}

/// Sets the states that mark the first instant of a run, when derivatives are 0 for any input.
void WorkingPoint::leave_start() {
  const auto& blocks = diagram_.plan.diagram.blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t s = 0; s < blocks[b].type().states.size(); ++s) {
      const plan::SignalSlot& slot = diagram_.plan.blocks[b].states[s];
      if (blocks[b].type().states[s].marks_start)
        std::fill_n(point_.values.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, 1.0);
    }
}

/// Cuts the wires; each holds its value of the uncut diagram.
void WorkingPoint::cut() {
  run_->evaluate();
  const plan::Plan& plan = diagram_.plan;
  for (const Place& input : inputs()) carried_.push_back(run_->values()[input.wire]);
  for (const int block : diagram_.cut) {
    const plan::PlannedBlock& junction = plan.blocks[static_cast<std::size_t>(block)];
    const plan::SignalSlot &wire = junction.inputs[0][0], &held = junction.states[Junction::held_state];
    for (std::size_t k = 0; k < static_cast<std::size_t>(held.size); ++k)
      point_.values[held.offset + k] = run_->values()[wire.offset + k];
    point_.values[junction.states[Junction::cut_state].offset] = 1.0;
  }
}

void WorkingPoint::find_states() {
  const auto& blocks = diagram_.plan.diagram.blocks;
  for (const bool continuous : {true, false})
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const BlockType& type = blocks[b].type();
      const bool counts =
          continuous ? !sampled_ || paths_.near_way(b) : sampled_ && paths_.samples[b] && paths_.on_way(b);
      if (!counts || &type == &junction_type()) continue;
      if (!continuous) find_circles(b);
      for (std::size_t s = 0; s < type.states.size(); ++s)
        if (type.states[s].continuous == continuous) add_state(b, s);
    }
}

/// Finds ring buffers: rows of samples with an index that advances with every update. Counted from the index,
/// they are the same linear system at every turn.
void WorkingPoint::find_circles(std::size_t block) {
  const BlockType& type = diagram_.plan.diagram.blocks[block].type();
  const plan::PlannedBlock& planned = diagram_.plan.blocks[block];
  const auto width = planned.outputs.empty() ? 1 : static_cast<std::size_t>(planned.outputs[0].size);
  const auto updates = static_cast<std::size_t>(base_ticks_ / planned.rate.ticks);
  const auto is_own = [&](std::size_t s) { return !type.states[s].continuous && !type.states[s].settable; };
  for (std::size_t i = 0; i < type.states.size(); ++i)
    for (std::size_t s = 0; s < type.states.size(); ++s) {
      if (i == s || !is_own(i) || !is_own(s) || planned.states[i].size != 1) continue;
      const auto size = static_cast<std::size_t>(planned.states[s].size);
      const std::size_t rows = size / width, index = planned.states[i].offset;
      if (type.states[s].shape.find("x n") == std::string::npos || rows * width != size) continue;
      if (!is_index(point_.values[index], rows) || !is_index(later_[index], rows)) continue;
      const auto before = static_cast<std::size_t>(point_.values[index]);
      if ((before + updates) % rows != static_cast<std::size_t>(later_[index])) continue;
      circles_.push_back({index, planned.states[s].offset, rows, width});
    }
}

void WorkingPoint::add_state(std::size_t block, std::size_t state) {
  const plan::SignalSlot& slot = diagram_.plan.blocks[block].states[state];
  const StateSpec& spec = diagram_.plan.diagram.blocks[block].type().states[state];
  if (spec.marks_start) return;
  const std::string name = diagram_.plan.diagram.blocks[block].name + "." + spec.name;
  const std::string unit = unit_of(diagram_.plan, {static_cast<int>(block), -1, static_cast<int>(state)});
  for (const Circle& circle : circles_)
    if (circle.index == slot.offset) return;
  if (is_count(spec, slot)) return counts_.push_back(name);
  for (std::size_t k = 0; k < static_cast<std::size_t>(slot.size); ++k) {
    StatePlace place;
    place.offset = slot.offset + k;
    place.channel = {slot.size > 1 ? fmt::format("{}.{}", name, k + 1) : name, unit};
    place.continuous = spec.continuous;
    place.may_count = !spec.continuous && spec.unit == "1";
    place.own = !spec.continuous && !spec.settable;
    for (std::size_t c = 0; c < circles_.size(); ++c)
      if (circles_[c].first == slot.offset) {
        place.circle = static_cast<int>(c);
        place.age = k / circles_[c].width;
        place.element = k % circles_[c].width;
        place.may_count = place.own = false;
      }
    states_.push_back(std::move(place));
  }
}

/// True for a possible index: a state of whole numbers without a unit that no file sets.
bool WorkingPoint::is_count(const StateSpec& spec, const plan::SignalSlot& slot) const {
  if (spec.continuous || spec.settable || spec.unit != "1") return false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(slot.size); ++k)
    if (point_.values[slot.offset + k] != std::floor(point_.values[slot.offset + k])) return false;
  return true;
}

double WorkingPoint::most_change(std::size_t column) const {
  const bool counts = column < states_.size() && states_[column].may_count;
  return counts ? 0.0625 : std::numeric_limits<double>::infinity();
}

std::size_t WorkingPoint::offset_of(const StatePlace& state, const double* values) const {
  if (state.circle < 0) return state.offset;
  const Circle& circle = circles_[static_cast<std::size_t>(state.circle)];
  const auto index = static_cast<std::size_t>(values[circle.index]);
  return circle.first + (index + state.age) % circle.rows * circle.width + state.element;
}

double WorkingPoint::value(std::size_t column) const {
  if (column < states_.size()) return point_.values[offset_of(states_[column], point_.values.data())];
  const std::size_t input = column - states_.size();
  return carried_[input] + point_.values[inputs()[input].offset];
}

std::pair<std::size_t, double> WorkingPoint::written(std::size_t column, double value) const {
  if (column < states_.size()) return {offset_of(states_[column], point_.values.data()), value};
  const std::size_t input = column - states_.size();
  return {inputs()[input].offset, value - carried_[input]};
}

void WorkingPoint::set(std::size_t column, double value) {
  const auto [place, number] = written(column, value);
  point_.values[place] = number;
}

Eigen::VectorXd WorkingPoint::respond(std::size_t column, double value) {
  const auto [place, number] = written(column, value);
  const double kept = std::exchange(point_.values[place], number);
  Eigen::VectorXd response = respond();
  point_.values[place] = kept;
  return response;
}

void WorkingPoint::step_to_next_sample() {
  run_->advance();
  for (std::int64_t tick = 1; tick < base_ticks_; ++tick) {
    run_->evaluate();
    run_->advance();
  }
}

Eigen::VectorXd WorkingPoint::respond() {
  const plan::Layout& layout = run_->plan().layout;
  run_->restore(point_);
  run_->evaluate();
  Eigen::VectorXd response(static_cast<Eigen::Index>(states_.size() + outputs().size()));
  auto row = static_cast<Eigen::Index>(states_.size());
  for (const Place& output : outputs()) response[row++] = run_->values()[output.offset];
  if (sampled_) step_to_next_sample();
  if (!sampled_) run_->find_slopes();
  const double* values = run_->values();
  row = 0;
  for (const StatePlace& state : states_)
    response[row++] =
        values[sampled_ ? offset_of(state, values) : layout.derivatives + state.offset - layout.states];
  return response;
}

}  // namespace stepwire::linear
