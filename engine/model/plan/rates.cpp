#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/io/environment_error.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

constexpr double max_ticks = 9e15;  // larger whole numbers are not exact in a double

void require_whole(Draft& draft, double time, const diagram::Origin& origin, const std::string& subject,
                   std::int64_t& ticks) {
  const double step = draft.diagram().step;
  if (const auto whole = whole_ticks(time, step)) {
    ticks = *whole;
    return;
  }
  draft.report.add(origin, subject,
                   fmt::format("{} s is not a whole multiple of the step {} s; e.g. {:.12g} s would be", time,
                               step, step * std::max(1.0, std::round(time / step))));
}

/// Returns the rate of a block with inputs of both rates.
Rate join(const Rate& a, const Rate& b) {
  if (a.kind == Rate::Kind::constant) return b;
  if (b.kind == Rate::Kind::constant) return a;
  if (a.kind == Rate::Kind::continuous || b.kind == Rate::Kind::continuous)
    return {Rate::Kind::continuous, 1};
  const std::int64_t ticks = std::gcd(std::gcd(a.ticks, b.ticks), a.first - b.first);
  return {Rate::Kind::discrete, ticks, a.first % ticks};
}

/// Determines the rate of every block. Blocks with a period, sources and blocks with continuous states start
/// with a rate of their own. A worklist then raises the rate of each reader to a common rate of all its
/// sources, until no rate changes.
class Rates {
 public:
  explicit Rates(Draft& draft) : draft_(draft), users_(draft.blocks.size()) {}

  void run() {
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) start(i);
    spread();
    // Blocks that act at ticks, but have no period from any input, act at every step.
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) {
      if (rate(i).kind != Rate::Kind::constant || !acts(draft_.diagram().blocks[i].type())) continue;
      rate(i) = {Rate::Kind::discrete, 1};
      queue_.push_back(i);
    }
    spread();
  }

 private:
  Rate& rate(std::size_t block) { return draft_.plan.blocks[block].rate; }

  static bool acts(const BlockType& type) { return type.timing == Timing::discrete || bool(type.run_update); }

  /// Propagates rates. They only rise (constant, slower, faster, continuous), so the iteration ends with a
  /// result independent of its order.
  void spread() {
    while (!queue_.empty()) {
      const std::size_t block = queue_.back();
      queue_.pop_back();
      for (std::size_t user : users_[block]) raise(user);
    }
  }

  void start(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& sources : block.inputs)
      for (const diagram::Source& source : sources)
        if (source.block >= 0) users_[static_cast<std::size_t>(source.block)].push_back(index);
    if (is_triggered(index)) refuse_what_needs_periods(block);
    if (block.every && draft_.diagram().events.locate) refuse_missed_edges(index);
    if (block.every && !waits_for_inputs(block)) {
      give_period(index, block);
    } else if (runs_each_tick(index)) {
      rate(index) = {Rate::Kind::discrete, 1};
    } else if (block.type().timing == Timing::continuous) {
      rate(index) = {Rate::Kind::continuous, 1};
    }
    if (rate(index).kind != Rate::Kind::constant) queue_.push_back(index);
  }

  /// Returns the block to use in place of a continuous one, as the end of a message; empty without one.
  static std::string discrete_text(const BlockType& type) {
    return type.discrete.empty() ? "" : ", or use " + type.discrete;
  }

  void give_period(std::size_t index, const diagram::DiagramBlock& block) {
    rate(index) = {Rate::Kind::discrete, 1};
    if (block.type().has_continuous_state())
      return draft_.report.add(block.every_origin, block.name + ".every",
                               fmt::format("{} has a continuous state and follows the solver; leave 'every' "
                                           "out{}{}",
                                           block.type().name, block.every_of_part ? " of its part" : "",
                                           discrete_text(block.type())));
    const std::string subject = block.name + ".every";
    require_whole(draft_, block.every->period, block.every_origin, subject, rate(index).ticks);
    if (block.every->offset > 0.0)
      require_whole(draft_, block.every->offset, block.every_origin, subject, rate(index).first);
  }

  /// True where a block ignores its period and runs only when its inputs change.
  static bool waits_for_inputs(const diagram::DiagramBlock& block) {
    return (block.every_of_part || block.guard >= 0) && block.type().timing == Timing::inherited &&
           !acts(block.type());
  }

  /// True where a block runs at single ticks of a trigger and is idle between them.
  bool is_triggered(std::size_t index) const { return trigger_of(index) != nullptr; }

  /// Returns the innermost guard with a trigger, or nullptr.
  const diagram::DiagramBlock* trigger_of(std::size_t index) const {
    const auto& blocks = draft_.plan.diagram.blocks;
    const int trigger = diagram::guard_type().input("trigger");
    for (int guard = blocks[index].guard; guard >= 0; guard = blocks[static_cast<std::size_t>(guard)].guard) {
      const diagram::DiagramBlock& block = blocks[static_cast<std::size_t>(guard)];
      if (!block.inputs[static_cast<std::size_t>(trigger)].empty()) return &block;
    }
    return nullptr;
  }

  /// True for guards, which detect every change, and for triggered blocks, which hold their outputs between
  /// ticks.
  bool runs_each_tick(std::size_t index) const {
    const diagram::DiagramBlock& block = draft_.plan.diagram.blocks[index];
    return &block.type() == &diagram::guard_type() || (is_triggered(index) && !waits_for_inputs(block));
  }

  void refuse_what_needs_periods(const diagram::DiagramBlock& block) {
    const BlockType& type = block.type();
    if (type.has_continuous_state())
      return draft_.report.add(block.origin, block.name,
                               fmt::format("{} has a continuous state, which would stand still between the "
                                           "edges of its trigger; use 'enable'{}",
                                           type.name, discrete_text(type)));
    const bool has_period =
        std::ranges::any_of(type.clocks, [](const ClockSpec& clock) { return clock.bind_period != nullptr; });
    if (!has_period || block.every) return;
    draft_.report.add(
        block.origin, block.name,
        fmt::format("{} computes with the time between its ticks, which a trigger leaves open; give what is "
                    "triggered an 'every': edges are looked for at that period, and each counts for one",
                    type.name));
  }

  /// An edge that is located acts at its instant, where a block with a period does not run.
  void refuse_missed_edges(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    const diagram::DiagramBlock* const trigger = trigger_of(index);
    if (trigger && !trigger->every)
      draft_.report.add(block.every_origin, block.name + ".every",
                        "edges of its trigger are located between ticks, where it does not run; give what is "
                        "triggered the 'every': then edges are looked for at that period");
  }

  void raise(std::size_t index) {
    const diagram::DiagramBlock& block = draft_.diagram().blocks[index];
    if (runs_each_tick(index)) return;
    const bool waits = waits_for_inputs(block);
    if ((block.every && !waits) || block.type().timing == Timing::continuous) return;
    Rate joined = rate(index);
    for (const auto& sources : block.inputs)
      for (const diagram::Source& source : sources)
        if (source.block >= 0) joined = join(joined, rate(static_cast<std::size_t>(source.block)));
    if (block.type().timing == Timing::discrete && joined.kind == Rate::Kind::continuous)
      joined = {Rate::Kind::discrete, 1};
    if (waits && joined.kind != Rate::Kind::constant && (block.every || is_triggered(index))) {
      if (rate(index).kind != Rate::Kind::constant) return;
      rate(index) = {Rate::Kind::discrete, 1};
      if (block.every) give_period(index, block);
      return queue_.push_back(index);
    }
    if (joined == rate(index)) return;
    rate(index) = joined;
    queue_.push_back(index);
  }

  Draft& draft_;
  std::vector<std::vector<std::size_t>> users_;
  std::vector<std::size_t> queue_;
};

void require_solver(Draft& draft) {
  diagram::Diagram& diagram = draft.diagram();
  if (!diagram.solver.empty()) return;
  for (const diagram::DiagramBlock& block : diagram.blocks)
    if (block.type().has_continuous_state())
      return draft.report.add(block.origin, block.name,
                              fmt::format("{} has a continuous state, and the diagram names no solver; add "
                                          "e.g. 'solver: rk4' to its head",
                                          block.type().name));
}

}  // namespace

std::optional<std::int64_t> whole_ticks(double time, double step) {
  const double ratio = time / step;
  const double ticks = std::round(ratio);
  if (!(ratio < max_ticks) || ticks < 1.0 || std::abs(ratio - ticks) > 1e-9 * ratio) return std::nullopt;
  return static_cast<std::int64_t>(ticks);
}

void plan_rates(Draft& draft) {
  diagram::Diagram& diagram = draft.diagram();
  require_whole(draft, diagram.stop, diagram.stop_origin, "stop", draft.plan.steps);
  require_solver(draft);
  Rates(draft).run();
  for (const diagram::RecordRequest& request : diagram.records) {
    std::int64_t ticks = 1;
    if (request.every) require_whole(draft, *request.every, request.origin, "record.every", ticks);
  }
}

}  // namespace stepwire::plan
