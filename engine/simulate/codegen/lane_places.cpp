#include "engine/simulate/codegen/lane_places.hpp"

#include <fmt/format.h>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

class Follower {
 public:
  Follower(const plan::Plan& plan, int lanes)
      : plan_(plan),
        result_{lanes, std::vector<bool>(plan.layout.size), std::vector<bool>(plan.blocks.size())} {}

  void add(const plan::RunDifferences& differences) {
    for (const plan::VariableBlock& variable : differences.variable) mark_block(variable.block);
    for (const diagram::Target& target : differences.values) {
      const auto block = static_cast<std::size_t>(target.block);
      if (target.kind != diagram::Target::Kind::constant)
        mark_block(block);
      else
        mark(plan_.blocks[block].inputs[static_cast<std::size_t>(target.index)]);
    }
  }

  LanePlaces take() {
    while (std::exchange(changed_, false))
      for (std::size_t b = 0; b < plan_.blocks.size(); ++b)
        if (!result_.blocks[b] && differs(b)) mark_block(b);
    return std::move(result_);
  }

 private:
  void mark_block(std::size_t index) {
    const plan::PlannedBlock& block = plan_.blocks[index];
    result_.blocks[index] = changed_ = true;
    for (const auto* slots : {&block.outputs, &block.states, &block.diagnostics}) mark(*slots);
    const BlockType& type = plan_.diagram.blocks[index].type();
    for (std::size_t s = 0; s < block.states.size(); ++s)
      if (type.states[s].continuous) mark({block.derivatives[s]});
  }

  void mark(const std::vector<plan::SignalSlot>& slots) {
    for (const plan::SignalSlot& slot : slots)
      for (std::size_t i = slot.offset; i < slot.offset + static_cast<std::size_t>(slot.size); ++i)
        result_.places[i] = true;
  }

  bool any(const std::vector<plan::SignalSlot>& slots) const {
    for (const plan::SignalSlot& slot : slots)
      for (std::size_t i = slot.offset; i < slot.offset + static_cast<std::size_t>(slot.size); ++i)
        if (result_.places[i]) return true;
    return false;
  }

  /// True if a block reads a number that differs between lanes. Also true if it writes to a place that
  /// differs because of another block, such as the derivative of a state.
  bool differs(std::size_t index) const {
    const plan::PlannedBlock& block = plan_.blocks[index];
    for (const auto& slots : block.inputs)
      if (any(slots)) return true;
    return any(block.outputs) || any(block.states);
  }

  const plan::Plan& plan_;
  LanePlaces result_;
  bool changed_ = true;
};

/// Placeholders: checked numbers, condition of `stop_when`, rows, condition after a step, workspace, start of
/// a step.
constexpr char form[] =
    "/// Lanes in which a number is not finite.\n"
    "inline unsigned unfinite(Lanes w) {{\n  LaneVector sum{{}};\n{0}"
    "  return lanes_where([&](unsigned l) {{ return !(sum[l] == 0.0); }});\n}}\n\n"
    "[[gnu::flatten]] inline void run(plan::LaneTask& task) {{\n"
    "{4}  const LaneNumbers numbers{{task.numbers}};\n"
    "  for (; task.tick < task.end && task.active != 0; ++task.tick) {{\n"
    "    const std::int64_t tick = task.tick;\n"
    "    evaluate(w, numbers, tick);\n"
    "    if (const unsigned wrong = unfinite(w) & task.active; wrong != 0) [[unlikely]]\n"
    "      task.leave(task, wrong, plan::LaneTask::evaluated);\n"
    "{1}"
    "    if (tick == task.stop && task.active != 0) task.leave(task, task.active, plan::LaneTask::last);\n"
    "    if (task.active == 0) return;\n"
    "{2}{5}"
    "    advance(w, numbers, tick);\n"
    "{3}"
    "  }}\n}}\n\n";

std::string leave_text(const std::string& condition, const char* how) {
  if (condition.empty()) return "";
  return fmt::format(
      "    if (const unsigned ended = lanes_where([&](unsigned l) {{ return {}; }}) & task.active; ended != "
      "0)\n"
      "      task.leave(task, ended, plan::LaneTask::{});\n",
      condition, how);
}

class StepsText {
 public:
  StepsText(const plan::Plan& plan, const LanePlaces& lanes) : plan_(plan), lanes_(lanes) {}

  std::string text(const std::string& workspace, const std::string& begin) const {
    return fmt::format(form, look_text(), leave_text(stop_condition(), "last"), rows_text(),
                       leave_text(ending_condition(), "advanced"), workspace, begin);
  }

 private:
  /// Returns "w.lane(l)[7]".
  std::string number(std::size_t offset) const {
    return fmt::format("w{}[{}]", lane_text(lanes_, lanes_.places[offset]), offset);
  }

  std::string look_text() const {
    std::string text;
    const plan::Layout& layout = plan_.layout;
    for (const auto& one : lanes_.stretches(layout.signals, layout.derivatives + layout.state_count))
      text += fmt::format("  add_unfinite{}(sum, w.first + {} * lanes, {});\n", one.differs ? "" : "_of_all",
                          one.first, one.end - one.first);
    return text;
  }

  std::string stop_condition() const {
    if (!plan_.diagram.stop_when) return "";
    return plan_.diagram.stop_when->expression.cpp_condition(
        [&](std::size_t i) { return number(plan_.offset(plan_.diagram.stop_when->variables[i])); });
  }

  std::string ending_condition() const {
    std::string text;
    for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
      const auto& specs = plan_.diagram.blocks[b].type().diagnostics;
      for (std::size_t n = 0; n < specs.size(); ++n)
        if (specs[n].ends_run)
          text += fmt::format("{}{} != Diagnostic::never", text.empty() ? "" : " || ",
                              number(plan_.blocks[b].diagnostics[n].offset));
    }
    return text;
  }

  std::string rows_text() const {
    std::string text;
    for (std::size_t r = 0; r < plan_.diagram.records.size(); ++r) {
      const std::int64_t every = record::ticks_between_rows(plan_, plan_.diagram.records[r]);
      const auto columns = record::recorded_columns(plan_, plan_.diagram.records[r]);
      if (every > 1) text += fmt::format("    if (tick % {} == 0)", every);
      text += fmt::format("    {{\n      double* const row = task.rows[{}];\n", r);
      for (std::size_t c = 0; c < columns.size(); ++c)
        text += fmt::format("      for (int l = 0; l < lanes; ++l) row[{} * lanes + l] = {};\n", c,
                            number(columns[c].offset));
      text += fmt::format("      task.rows[{}] = row + {} * lanes;\n    }}\n", r, columns.size());
    }
    return text;
  }

  const plan::Plan& plan_;
  const LanePlaces& lanes_;
};

}  // namespace

std::vector<LanePlaces::Stretch> LanePlaces::stretches(std::size_t first, std::size_t end) const {
  std::vector<Stretch> result;
  for (std::size_t i = first; i < end; ++i)
    if (!result.empty() && result.back().differs == places[i])
      ++result.back().end;
    else
      result.push_back({i, i + 1, places[i]});
  return result;
}

LanePlaces lane_places(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes) {
  Follower follower(plan, lanes);
  follower.add(differences);
  return follower.take();
}

std::string why_not_in_lanes(const plan::Plan& plan) {
  if (!plan.guards.empty()) return "blocks of it run on condition";
  if (!plan.loops.empty()) return "it has algebraic loops";
  if (!plan.late.empty()) return "resets of it read the states of each other";
  if (plan.crossing_count > 0) return "its events are located";
  if (solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value()))
    return plan.diagram.error_control ? "its solver chooses its steps" : "its solver is implicit";
  return "";
}

std::string lane_steps_text(const plan::Plan& plan, const LanePlaces& lanes, const std::string& workspace,
                            const std::string& begin) {
  return StepsText(plan, lanes).text(workspace, begin);
}

}  // namespace stepwire::codegen
