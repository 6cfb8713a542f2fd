#include "engine/simulate/realtime/loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stepwire::realtime {

namespace {

constexpr int warm_up_ticks = 100;

Eigen::Index size_of_input(const plan::Plan& plan, const diagram::DiagramInput& input) {
  return plan.blocks[static_cast<std::size_t>(input.block)].outputs.front().size;
}

}  // namespace

Loop::Loop(const plan::Plan& plan, const LoopOptions& options, Device& device, LoopClock& clock,
           LoopRecorder* recorder)
    : options_(options),
      ticks_(ticks_per_period(plan.diagram, options.rate)),
      device_(device),
      clock_(clock),
      recorder_(recorder),
      simulation_(options.values ? &options.values->active() : &own_.emplace(plan)),
      watched_({0, *simulation_}, options_.observers),
      deadlines_(options.rate, options.overrun),
      measurements_(options.deadlines),
      groups_(plan, clock) {
  require_fit_for_loop(plan);
  simulation_->go_on_unsolved();
  if (options.values) options.values->change_both([](run::Executor& run) { run.go_on_unsolved(); });
  if (options.code) simulation_->use(*options.code);
  warm_up();
  prepare_inputs();
  prepare_outputs();
}

/// Runs some ticks, after which code and numbers are cached and all pages are mapped.
void Loop::warm_up() {
  for (int tick = 0; tick < warm_up_ticks && simulation_->healthy(); ++tick) {
    simulation_->evaluate();
    simulation_->advance();
  }
  simulation_->reset();
}

void Loop::prepare_inputs() {
  const plan::Plan& plan = simulation_->plan();
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    input_offsets_.push_back(inputs_.size());
    const double* defaults =
        simulation_->values() + plan.blocks[static_cast<std::size_t>(input.block)].outputs.front().offset;
    inputs_.insert(inputs_.end(), defaults, defaults + size_of_input(plan, input));
  }
}

void Loop::prepare_outputs() {
  const plan::Plan& plan = simulation_->plan();
  for (const diagram::DiagramOutput& output : plan.diagram.outputs) {
    const plan::SignalSlot slot = plan.slot(output.signal);
    for (Eigen::Index k = 0; k < slot.size; ++k) {
      output_offsets_.push_back(slot.offset + static_cast<std::size_t>(k));
      safe_.emplace_back();
      if (output.safe) safe_.back() = (*output.safe)[output.safe->size() == 1 ? 0 : k];
    }
  }
  outputs_.assign(output_offsets_.size(), 0.0);
}

void Loop::serve(std::int64_t count) {
  const std::int64_t end = std::min(options_.deadlines, deadlines_.index() + count);
  if (!began_) {
    watched_.begin();
    device_.start();
  }
  deadlines_.start_at(clock_.now());
  if (!began_) began_ = deadlines_.at(0);
  const ThreadCounts before = ThreadCounts::now();
  while (!end_ && !pauses() && deadlines_.index() < end) wait_and_step(end);
  write_safe_values();
  counts_.add(before, ThreadCounts::now());
  if (!end_ && deadlines_.index() >= options_.deadlines) end_ = End::done;
  if (end_) watched_.end();
}

void Loop::wait_and_step(std::int64_t end) {
  clock_.sleep_until(deadlines_.at(deadlines_.index()));
  const std::int64_t woke = clock_.now();
  if (options_.interrupt && *options_.interrupt) {
    end_ = End::interrupted;
    return;
  }
  drop_missed(woke, end);
  if (!deadlines_.must_stop() && deadlines_.index() < end) step(woke);
  if (!end_ && deadlines_.must_stop()) end_ = End::stopped;
}

void Loop::drop_missed(std::int64_t now, std::int64_t end) {
  const std::int64_t first = deadlines_.index();
  const std::int64_t dropped = deadlines_.drop_missed(now, end);
  for (std::int64_t k = first; k < first + dropped; ++k) measurements_.woke(k, now - deadlines_.at(k));
}

void Loop::step(std::int64_t woke) {
  const std::int64_t k = deadlines_.index();
  const double wall = static_cast<double>(woke - *began_) * 1e-9;
  measurements_.woke(k, woke - deadlines_.at(k));
  if (options_.values) simulation_ = &options_.values->at_tick();
  if (!read_inputs(woke) || !may_tick()) return;
  groups_.before_tick(*simulation_);
  simulation_->evaluate();
  if (simulation_->healthy()) {
    serve_outputs(k);
    go_on(wall);
  } else if (recorder_) {
    recorder_->record_inputs(simulation_->tick(), inputs_.data());  // they may cause the fault
  }
  if (!simulation_->healthy())
    end_ = End::fault;
  else
    is_healthy();
  measurements_.stepped(k, clock_.now() - woke);
}

/// Completes the period after the outputs are written: records, states, and the further ticks. At a stop by
/// the overrun policy the states are skipped, so that the safe values are written at once.
void Loop::go_on(double wall) {
  record(wall);
  if (deadlines_.must_stop()) return;
  simulation_->advance();
  groups_.after_tick(*simulation_);
  for (std::int64_t tick = 1; tick < ticks_ && simulation_->healthy() && may_tick(); ++tick) {
    simulation_->evaluate();
    if (!simulation_->healthy()) return;
    record(wall);
    simulation_->advance();
  }
}

bool Loop::is_healthy() {
  if (!device_.healthy()) end_ = End::device;
  return device_.healthy();
}

bool Loop::read_inputs(std::int64_t began) {
  device_.read(inputs_.data());
  measurements_.read(clock_.now() - began);
  if (!is_healthy()) return false;
  for (std::size_t i = 0; i < input_offsets_.size(); ++i)
    simulation_->write_input(i, inputs_.data() + input_offsets_[i]);
  return true;
}

/// A loop that catches up gives a device no burst of commands: of deadlines that have passed, one command in
/// a period at most, and at last the newest.
void Loop::serve_outputs(std::int64_t k) {
  const std::int64_t now = clock_.now();
  const bool is_passed = deadlines_.at(k + 1) <= now && options_.overrun.kind == Overrun::Kind::catch_up;
  if (is_passed && now - written_at_ < deadlines_.at(k + 1) - deadlines_.at(k)) return deadlines_.served(now);
  write_outputs();
  count_written(k);
}

void Loop::write_outputs() {
  for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i] = simulation_->values()[output_offsets_[i]];
  const std::int64_t began = clock_.now();
  device_.write(outputs_.data());
  written_at_ = clock_.now();
  measurements_.wrote_device(written_at_ - began);
}

/// Counts the outputs for deadline k and for the dropped deadlines before it, which have waited for them too.
void Loop::count_written(std::int64_t k) {
  const std::int64_t written = clock_.now();
  for (; unwritten_ <= k; ++unwritten_) measurements_.wrote(unwritten_, written - deadlines_.at(unwritten_));
  deadlines_.served(written);
}

bool Loop::may_tick() {
  if (watched_.before_tick() == run::Flow::go_on) return true;
  end_ = End::stopped;
  return false;
}

void Loop::record(double wall) {
  watched_.evaluated();
  if (options_.tap) options_.tap->push(simulation_->tick(), simulation_->values());
  if (!recorder_) return;
  recorder_->record_inputs(simulation_->tick(), inputs_.data());
  recorder_->record_signals(simulation_->tick(), wall, simulation_->values());
}

/// Writes the safe values. The deadlines that still wait for outputs count as served with these.
void Loop::write_safe_values() {
  for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i] = safe_[i].value_or(outputs_[i]);
  device_.rest(outputs_.data());
  const std::int64_t written = clock_.now();
  for (; unwritten_ < measurements_.wake_up().count(); ++unwritten_)
    measurements_.wrote(unwritten_, written - deadlines_.at(unwritten_));
}

// Checks that a diagram is fit for a real-time loop before it begins.

std::int64_t ticks_per_period(const diagram::Diagram& diagram, double rate) {
  const double period = 1.0 / rate;
  if (const auto ticks = plan::whole_ticks(period, diagram.step)) return *ticks;
  const double near = std::max(1.0, std::round(period / diagram.step));
  throw yaml::Error(diagram.fault(
      diagram.step_origin, "step",
      fmt::format("the period of {:.9g} Hz, {:.6g} s, is no whole multiple of the step {:.6g} s; e.g. a rate "
                  "of {:.9g} Hz, or a step of {:.9g} s, would be",
                  rate, period, diagram.step, 1.0 / (near * diagram.step), period / near)));
}

void require_fit_for_loop(const plan::Plan& plan) {
  yaml::Faults faults;
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    if (!block.type().not_real_time.empty())
      faults.add(
          plan.diagram.fault(block.origin, block.name,
                             fmt::format("{} is not fit for a real-time loop: {}; 'stepwire run' takes it",
                                         block.type().name, block.type().not_real_time)));
  if (plan.diagram.events.locate)
    faults.add(plan.diagram.fault(plan.diagram.step_origin, "events",
                                  "a step that is split at events takes a time that nothing bounds, so a "
                                  "real-time loop takes none; leave 'events: locate' out"));
  faults.throw_if_any();
}

}  // namespace stepwire::realtime
