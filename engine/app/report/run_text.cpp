#include "engine/app/report/run_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/plan/element_slot.hpp"

namespace stepwire::report {
namespace {

std::string verdict_line(const claim::Verdict& verdict) {
  return fmt::format("  {} {}: {} ({}){}{}\n",
                     verdict.surprises() || verdict.fails() ? "FAIL"
                     : verdict.holds                        ? "ok  "
                                                            : "note",
                     text::visible(verdict.that), text::visible(verdict.shown), text::visible(verdict.check),
                     verdict.note.empty() ? "" : "; " + text::visible(verdict.note),
                     verdict.disagrees.empty()
                         ? ""
                         : fmt::format("; {}: {}", verdict.word(), text::visible(verdict.disagrees)));
}

/// Returns a line for each parameter that a call sets by a number without unit, which is taken in SI.
std::string settings_text(const diagram::Diagram& diagram) {
  std::string text;
  for (const diagram::DiagramParameter& parameter : diagram.parameters) {
    const double* number = std::get_if<double>(&parameter.value.content);
    const auto quantity = unit::parse_quantity(parameter.text);
    if (!parameter.set || !number || !parameter.dimension || *parameter.dimension == unit::Dimension{} ||
        !quantity || quantity->dimension || *number == 0.0)
      continue;
    text += fmt::format("  set  {} = {} {}\n", parameter.name, query::short_number(*number),
                        unit::si_name(*parameter.dimension));
  }
  return text;
}

}  // namespace

std::string outcome_text(const session::LoadedModel& model, const session::Outcome& outcome) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const std::size_t runs = std::max<std::size_t>(1, model.job.points.size());
  std::string text =
      fmt::format("{}\n  {}: {} blocks, {}{} ticks, {:.3g} s\n",
                  text::visible(diagram.title.empty() ? model.file : diagram.title),
                  text::visible(model.file), diagram.blocks.size(),
                  runs > 1 ? fmt::format("{} runs, ", runs) : "", outcome.result.ticks, outcome.seconds) +
      settings_text(diagram);
  std::size_t held = 0;
  for (const claim::Verdict& verdict : outcome.verdicts) {
    if (verdict.kind == claim::Claim::Kind::invariant && verdict.holds)
      ++held;
    else
      text += verdict_line(verdict);
  }
  for (const query::NamedTable& table : model.tables)
    if (table.name == session::sensitivity_table && !outcome.early()) text += text::text(*table.table);
  if (held > 0)
    text += fmt::format("  ok   held throughout: {} {}\n", held, held == 1 ? "invariant" : "invariants");
  for (const run::RaisedDiagnostic& diagnostic : outcome.result.diagnostics)
    text += fmt::format("  note {}: {} (first at {:.6g} s)\n", text::visible(diagnostic.block),
                        text::visible(diagnostic.text), diagnostic.time);
  for (const std::string& finding : session::findings_of(model, outcome))
    text += fmt::format("  note {}\n", text::visible(finding));
  return text;
}

std::string failures_text(const session::Outcome& outcome, const std::string& file) {
  std::string text;
  for (const claim::Verdict& verdict : outcome.verdicts)
    if (verdict.surprises() || verdict.fails()) text += verdict_line(verdict);
  return text.empty() ? "" : fmt::format("{}\n{}", text::visible(file), text);
}

std::string units_text(const plan::Plan& plan) {
  const diagram::Diagram& diagram = plan.diagram;
  std::string text;
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = diagram.blocks[b];
    for (std::size_t o = 0; o < block.type().outputs.size(); ++o) {
      const auto& dimension = diagram.output_dimensions[b][o];
      const std::string port = diagram::output_name(block.name, block.type(), o);
      const plan::SignalSlot& slot = plan.blocks[b].outputs[o];
      const std::string shape =
          slot.size == 1 ? "" : fmt::format(" ({})", plan::shape_text(slot.size, slot.columns));
      text += fmt::format("  {:<40} {}{}\n", text::visible(port),
                          dimension ? unit::si_name(*dimension) : "not known", shape);
    }
  }
  return text;
}

}  // namespace stepwire::report
