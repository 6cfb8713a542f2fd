#include "engine/simulate/codegen/lane_steps.hpp"

#include <fmt/format.h>

#include "engine/simulate/record/recorder.hpp"

namespace stepwire::codegen {

namespace {

/// Placeholders: checked numbers, condition of `stop_when`, rows, condition after a step.
constexpr char form[] =
    "/// Lanes in which a number is not finite.\n"
    "inline unsigned unfinite(Lanes w) {{\n  LaneVector sum{{}};\n{0}"
    "  return lanes_where([&](unsigned l) {{ return !(sum[l] == 0.0); }});\n}}\n\n"
    "[[gnu::flatten]] inline void run(plan::LaneTask& task) {{\n"
    "  const Lanes w{{task.values}};\n  const LaneNumbers numbers{{task.numbers}};\n"
    "  for (; task.tick < task.end && task.active != 0; ++task.tick) {{\n"
    "    const std::int64_t tick = task.tick;\n"
    "    evaluate(w, numbers, tick);\n"
    "    if (const unsigned wrong = unfinite(w) & task.active; wrong != 0) [[unlikely]]\n"
    "      task.leave(task, wrong, plan::LaneTask::evaluated);\n"
    "{1}"
    "    if (tick == task.stop && task.active != 0) task.leave(task, task.active, plan::LaneTask::last);\n"
    "    if (task.active == 0) return;\n"
    "{2}"
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

  std::string text() const {
    return fmt::format(form, look_text(), leave_text(stop_condition(), "last"), rows_text(),
                       leave_text(ending_condition(), "advanced"));
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

std::string lane_steps_text(const plan::Plan& plan, const LanePlaces& lanes) {
  return StepsText(plan, lanes).text();
}

}  // namespace stepwire::codegen
