#include "engine/simulate/run/health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/plan/run_ends.hpp"
#include "engine/model/signal/diagnostic.hpp"
#include "engine/simulate/run/faults.hpp"
#include "engine/simulate/run/finite.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/loop_task.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::run {

namespace {

/// Returns the first non-finite number; 0 if all are finite.
double first_not_finite(const double* values, const plan::SignalSlot& slot) {
  for (const double* value = values + slot.offset; value != values + slot.offset + slot.size; ++value)
    if (!std::isfinite(*value)) return *value;
  return 0.0;
}

std::string text_of_not_finite(double value, double time) {
  return fmt::format(
      "became {} at {:.12g} s; the run ends here. A smaller step, a stiff solver (rosenbrock, sdirk) or a "
      "check of the parameters helps",
      std::isnan(value) ? std::abs(value) : value, time);  // the sign of NaN has no meaning
}

}  // namespace

RunFault fault_of(const plan::Plan& plan, std::size_t block, const std::string& port, double time,
                  const std::string& message) {
  const diagram::DiagramBlock& from = plan.diagram.blocks[block];
  const std::string subject = port.empty() ? from.name : from.name + "." + port;
  return {from.name, port, time, plan.diagram.fault(from.origin, subject, message)};
}

Health::Health(const BoundBlocks& blocks)
    : blocks_(blocks),
      plan_(blocks.plan()),
      values_(blocks.values()),
      checked_(plan::active_pieces(plan_, plan_.layout.signals,
                                   plan_.layout.derivatives + plan_.layout.state_count)),
      ending_(plan::places_of_ends(plan_, true)),
      whole_ends_(plan::places_of_ends(plan_, false)) {}

bool Health::is_raised(const std::vector<std::size_t>& places) const {
  return !places.empty() &&
         std::ranges::any_of(places, [&](std::size_t place) { return values_[place] != Diagnostic::never; });
}

bool Health::has_ended() const {
  return end() <= values_[plan::Layout::time];
}

double Health::end() const {
  double first = Diagnostic::never;
  for (const std::size_t place : whole_ends_) first = std::min(first, values_[place]);
  return first;
}

std::int64_t Health::tick_of_end(std::int64_t tick) const {
  const double time = end();
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b)
    for (const plan::SignalSlot& slot : plan_.blocks[b].diagnostics)
      if (values_[slot.offset] == time && std::ranges::count(whole_ends_, slot.offset) > 0) {
        const plan::Rate& rate = plan_.blocks[b].rate;
        const std::int64_t passed = tick - rate.first;
        return rate.first + (passed < 0 ? 0 : passed / rate.ticks + 1) * rate.ticks;
      }
  return tick + 1;
}

void Health::look_at_step() {
  const plan::Layout& layout = plan_.layout;
  if (is_raised(ending_)) fine_ = false;
  if (values_[layout.report] != solve::StepReport::fine || !loops_solved()) fine_ = false;
  if (plan_.splits_steps() && values_[layout.events + solve::EventReport::end] != 0.0) fine_ = false;
}

bool Health::is_finite() const {
  for (const plan::ActivePiece& piece : checked_)
    if (piece.active < 0 || values_[piece.active] != 0.0)
      if (!all_finite(values_ + piece.first, piece.end - piece.first)) return false;
  return true;
}

bool Health::loops_solved() const {
  if (accepts_unsolved_) return true;
  return std::ranges::all_of(plan_.loops, [&](const plan::SolvedLoop& loop) {
    return values_[loop.report + solve::LoopReport::unsolved] == 0.0;
  });
}

std::optional<RunFault> Health::fault(double time) const {
  if (fine_) return std::nullopt;
  if (auto fault = diagnostic_fault()) return fault;
  if (!loops_solved()) {
    if (runs_away_in_loop(plan_, values_))
      if (auto cause = not_finite(time)) return cause;
    return fault_of_loops(plan_, values_);
  }
  if (plan_.splits_steps())
    if (auto fault = fault_of_events(plan_, values_, time)) return fault;
  if (auto fault = fault_of_step(plan_, values_, time)) return fault;
  return not_finite(time);
}

std::optional<RunFault> Health::diagnostic_fault() const {
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const auto& specs = plan_.diagram.blocks[b].type().diagnostics;
    for (std::size_t n = 0; n < specs.size(); ++n) {
      const double first = values_[plan_.blocks[b].diagnostics[n].offset];
      if (specs[n].ends_run && specs[n].is_fault && first != Diagnostic::never)
        return fault_of(plan_, b, "", first,
                        fmt::format("{} (at {:.12g} s); the run ends here", diagnostic_text(b, n), first));
    }
  }
  return std::nullopt;
}

/// Returns the fault of the first non-finite number. States are checked first: a diverged state is the cause
/// of the other numbers. Outputs follow in the order of computation, so the first one is the cause of the
/// later ones.
std::optional<RunFault> Health::not_finite(double time) const {
  for (const bool states : {true, false})
    for (const int index : plan_.memory_order) {
      const auto b = static_cast<std::size_t>(index);
      const BlockType& type = plan_.diagram.blocks[b].type();
      const auto& slots = states ? plan_.blocks[b].states : plan_.blocks[b].outputs;
      for (std::size_t i = 0; i < slots.size(); ++i) {
        const double value = first_not_finite(values_, slots[i]);
        if ((states && !type.states[i].continuous) || value == 0.0) continue;
        return fault_of(plan_, b, states ? type.states[i].name : type.outputs[i].name, time,
                        text_of_not_finite(value, time));
      }
    }
  return std::nullopt;
}

std::string Health::diagnostic_text(std::size_t block, std::size_t diagnostic) const {
  const DiagnosticSpec& spec = plan_.diagram.blocks[block].type().diagnostics[diagnostic];
  return spec.detail ? spec.doc + ": " + spec.detail(blocks_.memory(block)) : spec.doc;
}

std::vector<RaisedDiagnostic> Health::diagnostics() const {
  std::vector<RaisedDiagnostic> raised;
  for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan_.diagram.blocks[b];
    for (std::size_t n = 0; n < block.type().diagnostics.size(); ++n) {
      const double first = values_[plan_.blocks[b].diagnostics[n].offset];
      const DiagnosticSpec& spec = block.type().diagnostics[n];
      const bool is_fault = spec.ends_run && spec.is_fault;
      if (!is_fault && first != Diagnostic::never)
        raised.push_back({block.name, diagnostic_text(b, n), first});
    }
  }
  std::ranges::move(notes_on_small_states(plan_, values_), std::back_inserter(raised));
  std::ranges::move(notes_on_held_resets(plan_, values_), std::back_inserter(raised));
  return raised;
}

}  // namespace stepwire::run
