#include "engine/app/cli/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string_view>

#include "engine/app/cli/console.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

namespace {

std::string verdict_line(const Verdict& verdict) {
  return fmt::format(
      "  {} {}: {} ({}){}{}\n",
      verdict.surprises() || verdict.fails() ? "FAIL"
      : verdict.holds                        ? "ok  "
                                             : "note",
      visible(verdict.that), visible(verdict.shown), visible(verdict.check),
      verdict.note.empty() ? "" : "; " + visible(verdict.note),
      verdict.disagrees.empty() ? "" : fmt::format("; {}: {}", verdict.word(), visible(verdict.disagrees)));
}

ExitCode refused(std::string_view why, ExitCode code) {
  complain("{}\n", why);
  return code;
}

}  // namespace

std::string outcome_text(const Work& work, const Outcome& outcome) {
  const Diagram& diagram = work.job.plan.diagram;
  const std::size_t runs = std::max<std::size_t>(1, work.job.points.size());
  std::string text = fmt::format(
      "{}\n  {}: {} blocks, {}{} ticks, {:.3g} s\n",
      visible(diagram.title.empty() ? work.file : diagram.title), visible(work.file), diagram.blocks.size(),
      runs > 1 ? fmt::format("{} runs, ", runs) : "", outcome.result.ticks, outcome.seconds);
  std::size_t held = 0;
  for (const Verdict& verdict : outcome.verdicts) {
    if (verdict.kind == Claim::Kind::invariant && verdict.holds)
      ++held;
    else
      text += verdict_line(verdict);
  }
  if (held > 0)
    text += fmt::format("  ok   held throughout: {} {}\n", held, held == 1 ? "invariant" : "invariants");
  for (const RaisedNotice& notice : outcome.result.notices)
    text += fmt::format("  note {}: {} (first at {:.6g} s)\n", visible(notice.block), visible(notice.text),
                        notice.time);
  return text;
}

std::string units_text(const Diagram& diagram) {
  std::string text;
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const DiagramBlock& block = diagram.blocks[b];
    for (std::size_t o = 0; o < block.type().outputs.size(); ++o) {
      const auto& dimension = diagram.output_dimensions[b][o];
      const std::string port =
          block.type().outputs.size() == 1 ? block.name : block.name + "." + block.type().outputs[o].name;
      text += fmt::format("  {:<40} {}\n", visible(port), dimension ? si_name(*dimension) : "not known");
    }
  }
  return text;
}

void print_faults(const RunResult& result) {
  constexpr std::size_t most_shown = 10;
  const auto& faults = result.faults;
  for (std::size_t i = 0; i < std::min(faults.size(), most_shown); ++i)
    complain("{}\n", faults[i].fault.text());
  if (faults.size() > most_shown)
    complain("and {} more runs of the sweep ended early\n", faults.size() - most_shown);
}

ExitCode guarded(const std::function<ExitCode()>& action) {
  try {
    return action();
  } catch (const Error& error) {
    return refused(error.what(), ExitCode::wrong);
  } catch (const TableError& error) {
    return refused(visible(error.what()), ExitCode::wrong);
  } catch (const ProcessStopped&) {
    return ExitCode::interrupted;
  } catch (const std::length_error&) {  // a container that was asked for more than any memory has
    return refused("this run needs more memory than there can be", ExitCode::surroundings);
  } catch (const std::bad_alloc&) {
    return refused(
        "there is not enough memory for this run; record fewer signals or give 'record' an 'every'",
        ExitCode::surroundings);
  } catch (const std::exception& error) {  // SurroundingsError, system_error of files and threads, and others
    return refused(error.what(), ExitCode::surroundings);
  }
}

}  // namespace stepwire
