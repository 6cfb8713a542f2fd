#include "engine/app/report/tune_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::report {

namespace {

std::string in_unit_of(const tuning::TunedNumber& number, double si) {
  const unit::Unit unit = unit::parse_unit(number.unit).value_or(unit::Unit{});
  const bool is_si = number.unit.empty() && number.dimension && *number.dimension != unit::Dimension{};
  const std::string name = is_si ? unit::si_name(*number.dimension) : number.unit;
  return query::short_number(unit.from_si(si), 6) + (name.empty() ? "" : " " + name);
}

std::string objective_text(const tuning::TuneResult& result) {
  const bool has_unit = result.dimension && *result.dimension != unit::Dimension{};
  const std::string unit = has_unit ? " " + unit::si_name(*result.dimension) : "";
  std::string text = fmt::format("  objective {}{}", query::short_number(result.objective, 6), unit);
  if (std::isfinite(result.start_objective))
    text += fmt::format(", at the start {}{}", query::short_number(result.start_objective, 6), unit);
  if (!result.worst.empty()) text += fmt::format("; the worst run: {}", text::visible(result.worst));
  return text + "\n";
}

/// Returns a line such as "target ...: 0.312, off by -0.4 deviations (equals 0.311)".
std::string target_line(const tuning::TunedTarget& target) {
  return fmt::format("  target {}: {}, off by {} deviations ({})\n", text::visible(target.verdict.that),
                     text::visible(target.verdict.shown), query::short_number(target.off, 2),
                     text::visible(target.verdict.check));
}

/// Returns the row of the Jacobian of a target, such as "    per range: aspect 3.1, precision -12"; ""
/// without one.
std::string derivatives_line(const tuning::TuneResult& result, std::size_t target) {
  const auto& jacobian = result.resolution.jacobian;
  if (target >= jacobian.size()) return "";
  std::vector<std::string> terms;
  for (std::size_t k = 0; k < result.numbers.size(); ++k)
    terms.push_back(
        fmt::format("{} {}", result.numbers[k].name, query::short_number(jacobian[target][k], 3)));
  return fmt::format("    deviations from bound to bound: {}\n", fmt::join(terms, ", "));
}

std::string number_line(const tuning::TunedNumber& number, std::size_t width) {
  std::string text = fmt::format("  {:<{}}  {:<22} from {}", number.name, width,
                                 in_unit_of(number, number.value), in_unit_of(number, number.start));
  if (number.interval)
    text += fmt::format("; 95 %: {} to {}", in_unit_of(number, (*number.interval)[0]),
                        in_unit_of(number, (*number.interval)[1]));
  return text + "\n";
}

std::string singular_line(const tuning::Resolution& resolution) {
  std::vector<std::string> values;
  for (const double value : resolution.singular_values) values.push_back(query::short_number(value, 3));
  if (values.empty()) return "";
  return fmt::format(
      "  singular values {} (deviations of the targets from bound to bound; below 1 a direction is free)\n",
      fmt::join(values, ", "));
}

std::string claim_line(const tuning::TunedClaim& claim) {
  return fmt::format("  {} {}: {} ({})\n", claim.verdict.holds ? "ok  " : "FAIL",
                     text::visible(claim.verdict.that), text::visible(claim.verdict.shown),
                     text::visible(claim.verdict.check));
}

std::string tuning_summary(const tuning::TuneResult& result) {
  if (result.history.empty())
    return "tune: interrupted before the first run was done, so that there is nothing yet to write\n";
  if (result.numbers.empty()) return "tune: the call sets all parameters, which are looked at as they are\n";
  std::string text = fmt::format("tune: {}, {}", text::counted(result.numbers.size(), "parameter"),
                                 text::counted(result.history.size(), "evaluation"));
  if (result.runs > 1) text += fmt::format(" of {} runs each", result.runs);
  text += fmt::format(", {:.3g} s{}; {}", result.seconds, result.compiled ? ", compiled" : "", result.method);
  if (result.starts.size() > 1) {
    const auto found = std::ranges::count_if(
        result.starts, [](const tuning::TunedStart& start) { return start.objective.has_value(); });
    text += fmt::format(" from {} starts, {} of which hold all claims", result.starts.size(), found);
  }
  if (result.interrupted) return text + "; interrupted: this is the best so far\n";
  if (!result.feasible) return text + "; no point holds all claims: this one comes nearest\n";
  return text + (result.converged ? "\n" : "; not converged: allow more 'evaluations'\n");
}

}  // namespace

std::string tune_text(const tuning::TuneResult& result) {
  std::string text = tuning_summary(result);
  if (result.history.empty()) return text;
  std::size_t width = 0;
  for (const tuning::TunedNumber& number : result.numbers) width = std::max(width, number.name.size());
  for (const tuning::TunedNumber& number : result.numbers) text += number_line(number, width);
  text += objective_text(result);
  for (std::size_t i = 0; i < result.targets.size(); ++i)
    text += target_line(result.targets[i]) + derivatives_line(result, i);
  text += singular_line(result.resolution);
  for (const tuning::TunedClaim& claim : result.claims) text += claim_line(claim);
  for (const std::string& finding : result.findings)
    text += fmt::format("  note: {}\n", text::visible(finding));
  return text;
}

}  // namespace stepwire::report
