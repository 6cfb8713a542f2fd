#include "engine/app/report/loop_text.hpp"

#include <fmt/format.h>

#include "engine/app/session/version.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/realtime/machine.hpp"

namespace stepwire::report {
namespace {

constexpr std::size_t max_groups_shown = 8;

std::string or_none(const std::string& text) {
  return text.empty() ? "none" : text;
}

const diagram::Diagram& diagram_of(const session::LoopOutcome& outcome) {
  return outcome.loop.simulation().plan().diagram;
}

std::string head_text(const session::LoopOutcome& outcome) {
  const plan::Plan& plan = outcome.loop.simulation().plan();
  const realtime::Deadlines& deadlines = outcome.loop.deadlines();
  return fmt::format(
      "{}\n  {}: {} blocks, {} states, step {:.6g} s, {}; {:.6g} Hz for {:.6g} s, {}\n"
      "  {}: {} of {} deadlines, {} steps, diagram time {:.6g} s\n"
      "  missed {}: {} late, {} dropped; the longest row {}\n",
      text::visible(plan.diagram.title.empty() ? plan.diagram.file : plan.diagram.title),
      text::visible(plan.diagram.file), plan.diagram.blocks.size(),
      plan.layout.state_count + plan.layout.discrete_count, plan.diagram.step,
      outcome.loop.simulation().compiled() ? "compiled" : "interpreted", outcome.settings.rate,
      outcome.settings.duration, outcome.served.policy, session::end_word(outcome.loop.end()),
      deadlines.index(), outcome.settings.deadlines, outcome.loop.steps(), outcome.loop.simulation().time(),
      deadlines.missed(), deadlines.late(), deadlines.dropped(), deadlines.longest_row());
}

std::string row_of(const std::string& name, const realtime::Histogram& times) {
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  return fmt::format("  {:<22}{:>10.2f}{:>10.2f}{:>10.2f}{:>12.2f}\n", name, us(times.quantile(0.5)),
                     us(times.quantile(0.99)), us(times.quantile(0.999)), us(times.max()));
}

std::string times_text(const session::LoopOutcome& outcome) {
  const realtime::Measurements& measured = outcome.loop.measurements();
  return fmt::format("  {:<22}{:>10}{:>10}{:>10}{:>12}\n", "times in us", "p50", "p99", "p99.9", "max") +
         row_of("wake-up latency", measured.wake_up()) + row_of("response", measured.response()) +
         row_of("cost of a step", measured.step()) +
         (outcome.has_devices ? row_of("  read", measured.reading()) + row_of("  write", measured.writing())
                              : "");
}

std::string baseline_text(const realtime::CyclictestHistogram& baseline) {
  return fmt::format("  {:<22}{:>10}{:>10}{:>10}{:>12}  (whole us)\n", "cyclictest, by turns",
                     baseline.quantile(0.5), baseline.quantile(0.99), baseline.quantile(0.999),
                     baseline.max());
}

std::string groups_text(const std::vector<realtime::GroupCost>& costs) {
  std::vector<std::string> texts;
  for (const realtime::GroupCost& cost : costs)
    if (cost.samples > 0 && texts.size() < max_groups_shown)
      texts.push_back(fmt::format("{} ({}) {:.0f} ns", cost.type, cost.blocks, cost.mean));
  if (texts.empty()) return "";
  return fmt::format("  of a tick, sampled (one stretch of calls at each wake-up): {}{}\n",
                     fmt::join(texts, ", "), costs.size() > texts.size() ? ", ..." : "");
}

std::string counts_text(const session::LoopOutcome& outcome) {
  const realtime::ThreadCounts& counts = outcome.loop.counts();
  return fmt::format(
      "  thread: {} page faults ({} from a disk), {} requests for memory, {} voluntary context switches "
      "(each "
      "sleep is one), {} involuntary\n",
      counts.minor_faults + counts.major_faults, counts.major_faults,
      counts.allocations ? std::to_string(*counts.allocations) : "not counted", counts.voluntary,
      counts.involuntary);
}

std::string rows_text(const session::LoopRows& rows) {
  return fmt::format("  recorded: {} rows; lost {}: {} because the writer was late, {} because of the disk\n",
                     rows.written, rows.lost(), rows.lost_to_ring, rows.lost_to_disk);
}

std::string notes_text(const session::LoopOutcome& outcome) {
  std::string text;
  for (const run::RaisedDiagnostic& diagnostic : outcome.loop.simulation().diagnostics())
    text += fmt::format("  note {}: {} (first at {:.6g} s)\n", text::visible(diagnostic.block),
                        text::visible(diagnostic.text), diagnostic.time);
  for (const run::LoopCost& loop : outcome.loop.simulation().loop_costs())
    if (loop.unsolved > 0)
      text += fmt::format(
          "  note the algebraic loop {} is not solved within {} iterations at {} of {} instants (first at "
          "{:.6g} "
          "s)\n",
          text::visible(loop.path), diagram_of(outcome).algebraic_loops.max_iterations, loop.unsolved,
          loop.instants, loop.first_unsolved);
  for (const std::string& line : outcome.device_lines) text += fmt::format("  {}\n", text::visible(line));
  for (const std::string& line : outcome.served.refused) text += fmt::format("  note {}\n", line);
  if (diagram_of(outcome).stop < outcome.settings.duration)
    text += fmt::format("  note the file's stop of {:.6g} s does not end a loop\n", diagram_of(outcome).stop);
  return text;
}

std::string machine_text(const realtime::Machine& machine) {
  return fmt::format(
      "  machine: {}, {} processors{}; kernel {}; clock {}, governor {}, isolated {}\n"
      "  kernel options for timing: {}\n  built with {}\n",
      machine.processor, machine.processors, machine.virtual_machine ? ", virtual" : "", machine.kernel,
      machine.clock_source, or_none(machine.governor), or_none(machine.isolated),
      or_none(machine.kernel_line), session::compiler_version());
}

}  // namespace

std::string loop_text(const session::LoopOutcome& outcome) {
  std::string text = head_text(outcome) + times_text(outcome);
  if (outcome.baseline) text += baseline_text(outcome.baseline->histogram());
  text += groups_text(outcome.loop.group_costs()) + counts_text(outcome);
  if (outcome.rows) text += rows_text(*outcome.rows);
  return text + notes_text(outcome) + machine_text(realtime::Machine::here());
}

}  // namespace stepwire::report
