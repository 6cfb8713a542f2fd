#include "engine/app/report/fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/query/number.hpp"
#include "engine/app/session/fitting.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::report {

namespace {

constexpr double strong = 0.95;  // absolute correlation from which a pair is reported

/// Fitted number in the unit of the diagram file.
class Shown {
 public:
  explicit Shown(const estimation::FittedNumber& number)
      : unit_(unit::parse_unit(number.unit).value_or(unit::Unit{})) {
    name_ = number.unit.empty() && number.dimension && *number.dimension != unit::Dimension{}
                ? unit::si_name(*number.dimension)
                : number.unit;
  }
  double value(double si) const { return unit_.from_si(si); }
  double width(double si) const { return unit_.from_si(si) - unit_.from_si(0.0); }
  const std::string& unit() const { return name_; }

 private:
  unit::Unit unit_;
  std::string name_;
};

/// Returns the available standard errors, each with its name.
std::string errors_of(const estimation::FittedNumber& number, const Shown& shown) {
  const std::string classical = fmt::format("{:.2g} classical", shown.width(number.classical_error));
  if (!std::isfinite(number.serial_error)) return classical;
  return fmt::format("{:.2g} serial, {}", shown.width(number.serial_error), classical);
}

/// True where the records fit so well that only rounding error is left.
bool is_exact(const estimation::FittedNumber& number) {
  constexpr double rounding = 1e-13, nothing = 1e-100;
  return number.standard_error <= std::max(rounding * std::abs(number.value), nothing);
}

std::string number_line(const estimation::FittedNumber& number, std::size_t width) {
  const Shown shown(number);
  const std::string unit = shown.unit().empty() ? "" : " " + shown.unit();
  const std::string value = query::short_number(shown.value(number.value), 6) + unit;
  if (number.at_bound)  // its interval would extend beyond the bound
    return fmt::format("  {:<{}}  {:<22} at its bound\n", number.title(), width, value);
  if (!std::isfinite(number.standard_error))
    return fmt::format("  {:<{}}  {}\n", number.title(), width, value);
  if (is_exact(number))
    return fmt::format("  {:<{}}  {:<22} exact but for rounding\n", number.title(), width, value);
  return fmt::format("  {:<{}}  {:<22} +- {} (95 %: {} to {})\n", number.title(), width, value,
                     errors_of(number, shown), query::short_number(shown.value(number.low), 6),
                     query::short_number(shown.value(number.high), 6));
}

std::string correlations(const estimation::FitResult& result) {
  std::string text;
  for (Eigen::Index i = 0; i < result.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (std::abs(result.correlation(i, j)) > strong)
        text += fmt::format("  {} and {} go together: correlation {:.3f}\n",
                            result.numbers[static_cast<std::size_t>(j)].title(),
                            result.numbers[static_cast<std::size_t>(i)].title(), result.correlation(i, j));
  return text;
}

/// Returns a line on the standard errors of the intervals; empty if there is only one kind.
std::string errors_line(const estimation::FitResult& result) {
  if (!result.in_time || result.together == 0) return "";
  const bool serial = result.standard_errors == estimation::StandardErrors::serial;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const estimation::FittedNumber& one : result.numbers) {
    const double factor = one.serial_error / one.classical_error;
    if (!std::isfinite(factor)) continue;
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  std::string text = fmt::format("  residuals go together over {} rows; intervals by the {} standard errors",
                                 result.together, serial ? "serial" : "classical");
  if (most > 0.0)
    text += fmt::format(", serial ones are {:.2f} to {:.2f} times the classical ones", least, most);
  return text + "\n";
}

std::string record_line(const estimation::FittedRecord& record, std::size_t width) {
  std::string text =
      fmt::format("  {:<{}}", record.label.empty() ? "the record" : text::visible(record.label), width);
  for (const estimation::ComparedRows& rows : record.comparisons)
    text += "  " + session::agreement_text(rows, 6);
  if (record.comparisons.empty()) text += "  not predicted";
  return text + (record.held_out ? "  held out\n" : "\n");
}

std::string summary(const estimation::FitResult& result) {
  if (result.interrupted && result.records.empty())
    return "fit: interrupted before the first run was done, so that there is nothing yet to write\n";
  const auto finished = std::count_if(result.starts.begin(), result.starts.end(),
                                      [](const estimation::FittedStart& start) { return start.finished; });
  std::size_t rows = 0;
  for (const estimation::FittedRecord& record : result.records) rows += record.held_out ? 0 : record.rows;
  if (result.numbers.empty())
    return fmt::format("fit: the call sets all parameters, by which {} rows are predicted\n", rows);
  std::string text =
      fmt::format("fit: {}, {}, {:.3g} s{}", text::counted(result.numbers.size(), "number"),
                  text::counted(rows, "row"), result.seconds, result.compiled ? ", compiled" : "");
  if (result.starts.size() > 1)
    text += fmt::format("; {} starts, {} of them to the end", result.starts.size(), finished);
  if (result.interrupted) return text + "; interrupted: this is the best so far\n";
  if (result.limited) return text + "; held by what the diagram refuses: see the note\n";
  if (result.astray) return text + "; not converged: at no certain minimum, see the note\n";
  return text + (result.converged ? "\n" : "; not converged: allow more 'iterations'\n");
}

}  // namespace

std::string fit_text(const estimation::FitResult& result) {
  std::size_t names = 0, labels = 10;
  for (const estimation::FittedNumber& number : result.numbers)
    names = std::max(names, number.title().size());
  for (const estimation::FittedRecord& record : result.records)
    labels = std::max(labels, record.label.size());
  std::string text = summary(result);
  for (const estimation::FittedNumber& number : result.numbers) text += number_line(number, names);
  text += errors_line(result);
  text += correlations(result);
  for (const estimation::FittedRecord& record : result.records) text += record_line(record, labels);
  for (const std::string& finding : result.findings)
    text += fmt::format("  note: {}\n", text::visible(finding));
  return text;
}

}  // namespace stepwire::report
