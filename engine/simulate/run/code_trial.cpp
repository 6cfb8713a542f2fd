#include "engine/simulate/run/code_trial.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/subprocess/isolated.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/lane_group.hpp"

namespace stepwire::run {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest{5};
constexpr double apart = 1e-3;  // relative difference of the states of two lanes
constexpr std::size_t most_text = 2000, memory = std::size_t{8} << 30;  // [bytes]

/// True if two numbers have the same bits, or both are NaN of any sign and payload.
bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// Returns the name of an element of a slot, "x" or "x.2"; an empty text for a place outside of it.
std::string name_in(const plan::SignalSlot& slot, const std::string& name, std::size_t place) {
  if (place < slot.offset || place - slot.offset >= static_cast<std::size_t>(slot.size)) return "";
  return slot.size == 1 ? name : fmt::format("{}.{}", name, place - slot.offset + 1);
}

/// Returns the name of the output, state or diagnostic that has this place of the workspace.
std::string name_of(const plan::Plan& plan, std::size_t place) {
  std::string name;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    const BlockType& type = block.type();
    const plan::PlannedBlock& planned = plan.blocks[b];
    for (std::size_t o = 0; o < planned.outputs.size() && name.empty(); ++o)
      name = name_in(planned.outputs[o], diagram::output_name(block.name, type, o), place);
    for (std::size_t s = 0; s < planned.states.size() && name.empty(); ++s)
      name = name_in(planned.states[s], fmt::format("{}.{}", block.name, type.states[s].name), place);
    for (const plan::SignalSlot& slot : planned.diagnostics)
      if (name.empty()) name = name_in(slot, "a diagnostic of " + block.name, place);
    if (!name.empty()) return name;
  }
  return "a number of the solver";
}

using Range = std::pair<std::size_t, std::size_t>;  ///< range [first, second) of the workspace

/// Returns the ranges of states and diagnostics. Between two ticks compiled code may hold signals in
/// registers.
std::vector<Range> between_ticks(const plan::Layout& layout) {
  return {{layout.states, layout.states + layout.state_count},
          {layout.discrete, layout.discrete + layout.discrete_count},
          {layout.diagnostics, layout.diagnostics + layout.diagnostic_count}};
}

/// Returns the ranges of all outputs and states. Some outputs share the places of derivatives.
std::vector<Range> at_tick(const plan::Plan& plan) {
  const plan::Layout& layout = plan.layout;
  std::vector<Range> ranges = between_ticks(layout);
  ranges.emplace_back(layout.signals, layout.states);
  for (const plan::PlannedBlock& block : plan.blocks)
    for (const plan::SignalSlot& slot : block.outputs)
      if (slot.offset - layout.derivatives < layout.state_count)
        ranges.emplace_back(slot.offset, slot.offset + static_cast<std::size_t>(slot.size));
  return ranges;
}

std::string difference_text(const std::string& name, double compiled, double interpreted, double time) {
  return fmt::format("{} is {} at {:.12g} s, where the interpreter has {}", name, compiled, time,
                     interpreted);
}

/// Compares two runs of one plan at the same instant.
std::string difference_in(const std::vector<Range>& ranges, const Executor& interpreted,
                          const Executor& compiled) {
  const plan::Plan& plan = interpreted.plan();
  const double *a = interpreted.values(), *b = compiled.values();
  for (const auto& [first, end] : ranges)
    for (std::size_t i = first; i < end; ++i)
      if (!same(a[i], b[i])) return difference_text(name_of(plan, i), b[i], a[i], interpreted.time());
  if (interpreted.healthy() == compiled.healthy()) return "";
  return fmt::format("at {:.12g} s only {} ends the run", interpreted.time(),
                     compiled.healthy() ? "the interpreter" : "that code");
}

std::string difference_of_rows(const record::Recording& interpreted, const record::Recording& compiled) {
  const std::vector<double>& time = interpreted.table.columns.front().values;
  for (std::size_t c = 0; c < interpreted.table.columns.size(); ++c) {
    const std::vector<double>&a = interpreted.table.columns[c].values, &b = compiled.table.columns[c].values;
    if (a.size() != b.size())
      return fmt::format("it has {}, and the interpreter {}", text::counted(b.size(), "row"), a.size());
    for (std::size_t row = 0; row < a.size(); ++row)
      if (!same(a[row], b[row]))
        return difference_text(interpreted.table.columns[c].name, b[row], a[row], time[row]);
  }
  return "";
}

std::string read_all(const io::Descriptor& file) {
  std::string text(most_text, ' ');
  const ssize_t size = ::read(file.number(), text.data(), text.size());
  text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return text;
}

/// Calls a trial in a child process, since wrong code may crash or not terminate. Returns a sentence on the
/// fault; an empty text without one.
std::string fault_of_trial(const std::function<std::string()>& trial) {
  constexpr const char* cause = "; this is a fault of the program or of the compiler";
  try {
    const std::string difference = read_all(subprocess::call_isolated(
        [&](int output) {
          const std::string found = trial().substr(0, most_text);
          if (::write(output, found.data(), found.size()) < 0) throw std::runtime_error("no room");
        },
        {subprocess::usual_limit(), memory}));
    return difference.empty() ? "" : "compiled code gives other numbers: " + difference + cause;
  } catch (const subprocess::IsolationError& error) {
    return std::string("compiled code ") + error.what() + " in its trial" + cause;
  }
}

plan::Plan shortened(const plan::Plan& plan, std::int64_t ticks) {
  plan::Plan made = plan;
  made.steps = std::min(made.steps, ticks);
  return made;
}

/// Trial of lane code: makes runs of a plan in lanes, and each of them alone.
class LaneTrial {
 public:
  LaneTrial(const plan::Plan& plan, const plan::CompiledLanes& code) : code_(code) {
    for (int lane = 0; lane < code.lanes; ++lane) add(plan, lane);
  }

  std::string difference() {
    std::vector<LaneGroup::Run> runs;
    for (Lane& lane : lanes_) runs.push_back({lane.together.get(), &lane.in_lanes->recorders()});
    LaneGroup group(code_, std::move(runs));
    if (!group.fits()) return "";
    while (group.goes_on()) group.step(LaneGroup::ticks_at_once);
    for (Lane& lane : lanes_)
      if (std::string found = difference_of(lane); !found.empty()) return found;
    return "";
  }

 private:
  struct Lane {
    std::unique_ptr<Executor> together, alone;
    std::unique_ptr<record::RunRecording> in_lanes, interpreted;
  };

  void add(const plan::Plan& plan, int lane) {
    Lane& made = lanes_.emplace_back();
    made.together = std::make_unique<Executor>(plan);
    made.alone = std::make_unique<Executor>(plan);
    made.in_lanes = std::make_unique<record::RunRecording>(plan);
    made.interpreted = std::make_unique<record::RunRecording>(plan);
    Workspace start = made.together->workspace();
    const plan::Layout& layout = plan.layout;
    for (std::size_t i = layout.states; i < layout.states + layout.state_count; ++i)
      if (code_.differs[i]) start.values[i] += apart * lane;
    made.together->restore(start);
    made.alone->restore(start);
  }

  static std::string difference_of(Lane& lane) {
    Drive(*lane.alone, lane.interpreted->recorders()).run();
    const auto &alone = lane.interpreted->finished(), &together = lane.in_lanes->finished();
    for (std::size_t r = 0; r < alone.size(); ++r)
      if (std::string found = difference_of_rows(alone[r], together[r]); !found.empty()) return found;
    return difference_in(between_ticks(lane.alone->plan().layout), *lane.alone, *lane.together);
  }

  const plan::CompiledLanes& code_;
  std::vector<Lane> lanes_;
};

std::string difference_of(const plan::Plan& plan, const plan::CompiledPlan& code) {
  Executor interpreted(plan), compiled(plan);
  compiled.use(code);
  const StopConditionEvaluator stopper(plan);
  const std::vector<Range> here = at_tick(plan), between = between_ticks(plan.layout);
  const Clock::time_point end = Clock::now() + longest;
  while (interpreted.tick() < trial_ticks && Clock::now() < end) {
    interpreted.evaluate();
    compiled.evaluate();
    if (std::string found = difference_in(here, interpreted, compiled); !found.empty()) return found;
    if (!interpreted.healthy() || interpreted.finished() || stopper.stops(interpreted.values())) return "";
    interpreted.advance();
    compiled.advance();
    if (std::string found = difference_in(between, interpreted, compiled); !found.empty()) return found;
    if (!interpreted.healthy()) return "";
  }
  return "";
}

std::string difference_of(const plan::Plan& plan, const plan::CompiledLanes& code) {
  const plan::Plan first_ticks = shortened(plan, trial_ticks / code.lanes);
  return LaneTrial(first_ticks, code).difference();
}

/// Trial against the interpreter; stateless.
class InterpreterTrial : public plan::CodeTrial {
 public:
  std::string fault(const plan::Plan& plan, const plan::CompiledPlan& code) const override {
    return fault_of_trial([&] { return difference_of(plan, code); });
  }
  std::string fault(const plan::Plan& plan, const plan::CompiledLanes& code) const override {
    return fault_of_trial([&] { return difference_of(plan, code); });
  }
};

}  // namespace

const plan::CodeTrial& code_trial() {
  static const InterpreterTrial trial;
  return trial;
}

}  // namespace stepwire::run
