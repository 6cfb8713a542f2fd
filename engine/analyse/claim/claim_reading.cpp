#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/likeness.hpp"
#include "engine/analyse/claim/reduce.hpp"
#include "engine/analyse/claim/reduced_value.hpp"
#include "engine/analyse/claim/run_formula.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::claim {

using yaml::form;

namespace {

/// True if a comparison accepts every number of a range.
bool accepts(const Comparison& comparison, const ReducedValue& range) {
  const double low = comparison.low, within = comparison.within;
  switch (comparison.kind) {
    case Comparison::Kind::at_most:
      return low >= range.most;
    case Comparison::Kind::at_least:
      return low <= range.least;
    case Comparison::Kind::between:
      return low <= range.least && comparison.high >= range.most;
    case Comparison::Kind::equals:
      break;
  }
  return std::isfinite(range.most) && low - within <= range.least && low + within >= range.most;
}

/// True for a formula that reads nothing of the run. Parameters count as part of the run, since they may be
/// fitted. So do the values of figures, scenes and blocks: a claim about them can fail.
bool names_nothing(const query::Formula& formula, const query::SymbolTable& names) {
  return formula.columns.empty() && formula.text.find('$') == std::string::npos &&
         std::ranges::none_of(names.drawn, [&](const query::NamedFormula& one) {
           return formula.text.find(one.name) != std::string::npos;
         });
}

std::string range_text(const ReducedValue& range) {
  if (!std::isfinite(range.most)) return fmt::format("is {:g} or more", range.least);
  if (!std::isfinite(range.least)) return fmt::format("is {:g} or less", range.most);
  return fmt::format("lies between {:g} and {:g}", range.least, range.most);
}

/// Returns advice on a bound with which the claim can fail.
std::string failing_limit(Comparison::Kind kind, const ReducedValue& range) {
  switch (kind) {
    case Comparison::Kind::at_least:
      return fmt::format("give a number above {:g}", range.least);
    case Comparison::Kind::at_most:
      return fmt::format("give a number below {:g}", range.most);
    default:
      return "leave out a part of that range";
  }
}

/// Adds a fault for a claim whose verdict does not depend on the run. Either no formula reads anything of the
/// run, or the comparison accepts every number that the reduction can return ('fraction' at least 0).
void check_can_fail(const yaml::Node& node, const Claim& claim, const query::NamesReading& read) {
  static const std::vector<std::string> keys{"equals", "at_most", "at_least", "between"};
  const std::string &reduced = reduction_names()[static_cast<std::size_t>(claim.reduction)],
                    &compared = keys[static_cast<std::size_t>(claim.comparison.kind)];
  const auto is_fixed = [&](const query::Formula& formula) { return names_nothing(formula, read.names); };
  if (std::ranges::all_of(claim.values, is_fixed) && (!claim.where || is_fixed(*claim.where)))
    return yaml::below(read, reduced)
        .fault(node.find(reduced)->mark,
               fmt::format("'{}' names nothing that the run gives, so that nothing is judged of it; name a "
                           "recorded signal",
                           claim.values.front().text));
  const ReducedValue& range = reduced_value(claim.reduction);
  if (accepts(claim.comparison, range))
    yaml::below(read, compared)
        .fault(node.find(compared)->mark,
               fmt::format("'{}' {}, so that this cannot fail; {}", reduced, range_text(range),
                           failing_limit(claim.comparison.kind, range)));
}

/// Adds a fault unless a number has the unit of the claim's value, or both are in SI.
void check_unit(const query::WantedNumber& number, const yaml::Node& node, const Claim& claim,
                const std::optional<unit::Dimension>& dimension, const query::NamesReading& read) {
  query::check_dimension(number, {dimension, is_ratio(claim)}, "the claim's value", node, read.names,
                         read.subject, read.faults);
  const bool has_unit =
      number.dimension && (*number.dimension != unit::Dimension{} || number.dimension->angle != 0.0);
  if (!has_unit || dimension || claim.values.empty()) return;
  const bool is_integral = claim.reduction == Reduction::iae;
  const unit::Dimension of_value =
      is_integral ? *number.dimension / unit::parse_unit("s")->dimension : *number.dimension;
  read.fault(node.mark,
             fmt::format("{} has a unit, but that of '{}' is not known; {}", number.text,
                         claim.values.front().text, query::unit_cure(claim.values.front(), of_value)));
}

bool has_offset(const std::string& unit) {
  const auto parsed = unit::parse_unit(unit);
  return parsed && parsed->offset != 0.0L;
}

/// Adds a fault for a bare number if the value is shown in a unit other than SI.
void refuse_bare(const yaml::Node& node, const std::string& unit, const query::NamesReading& read) {
  if (auto wrong = query::bare_number(node.text, unit, "the value")) read.fault(node.mark, std::move(*wrong));
}

/// Reads the number on the right of a comparison, in SI. Adds a fault and returns std::nullopt if its unit
/// does not fit the value.
std::optional<double> read_compared(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  auto number = query::read_number(node, read.names, read.subject, read.faults);
  if (!number) return std::nullopt;
  if (claim.reduction == Reduction::fit && number->unit == "%") return 100.0 * number->value;
  check_unit(*number, node, claim, reduced_dimension(claim), read);
  if (claim.comparison.unit.empty())
    claim.comparison.unit = number->unit;
  else
    refuse_bare(node, claim.comparison.unit, read);
  return number->value;
}

/// Returns a number as written in the file, a formula without its `=`; the SI unit is appended to a number
/// without a unit.
std::string written_number(const yaml::Node& node, const Claim& claim) {
  if (node.text.starts_with('=')) return node.text.substr(node.text.find_first_not_of("= "));
  const auto number = unit::parse_quantity(node.text);
  const auto dimension = reduced_dimension(claim);
  if (!number || number->dimension || !dimension || *dimension == unit::Dimension{}) return node.text;
  return node.text + " " + unit::si_name(*dimension);
}

/// Reads both ends of `between`.
void read_between(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  const auto* ends = read.pair(node, yaml::like("[3.1 N, 3.3 N]", {}));
  if (!ends) return;
  const yaml::Node &first = ends->front(), &second = ends->back();
  const bool has_unit = !claim.comparison.unit.empty();
  const auto low = read_compared(first, claim, read), high = read_compared(second, claim, read);
  if (!has_unit) refuse_bare(first, claim.comparison.unit, read);  // which the second end may have given
  if (low && high && *low > *high)
    read.fault(node.mark,
               fmt::format("{} is above {}; the smaller number comes first", first.text, second.text));
  claim.comparison.low = low.value_or(0.0);
  claim.comparison.high = high.value_or(0.0);
  claim.comparison.text =
      fmt::format("between {} and {}", written_number(first, claim), written_number(second, claim));
}

/// Reads the tolerance of `equals`.
void read_within(Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
  if (claim.like) return read_likeness_within(*claim.like, node, read);
  Comparison& comparison = claim.comparison;
  const auto number = query::read_number(node, read.names, read.subject, read.faults);
  if (!number || comparison.kind != Comparison::Kind::equals) return;
  const bool relative = number->unit == "%";
  if (!relative) check_unit(*number, node, claim, difference_dimension(claim), read);
  if (!relative) refuse_bare(node, unit_of_difference(comparison.unit), read);
  if (relative && has_offset(comparison.unit))
    read.fault(node.mark,
               fmt::format("{} of a temperature in {} is a share of its kelvins; give a tolerance in K",
                           node.text, comparison.unit));
  comparison.within = relative ? number->value * std::abs(comparison.low) : number->value;
  comparison.text += " within " + written_number(node, claim);
  if (relative && comparison.low == 0.0)
    read.fault(node.mark,
               fmt::format("{} of 0 is 0; give a tolerance with the unit of the value", node.text));
  if (comparison.within < 0.0) read.fault(node.mark, "a tolerance is not negative");
}

using ClaimRow = yaml::KeyRow<Claim, query::NamesReading>;

/// Reads a value that is a number per run (a run formula).
std::optional<query::Formula> read_of_run(const yaml::Node& node, Claim& claim,
                                          const query::NamesReading& read) {
  auto of_run = read_run_formula(node, read);
  if (!of_run) return std::nullopt;
  query::Formula value = *of_run->formula;
  value.text = of_run->text;
  claim.of_run = std::make_shared<const RunFormula>(std::move(*of_run));
  return value;
}

/// Reads a value followed by the unit in which it is shown: `x in mm`.
std::optional<query::Formula> read_with_unit(const yaml::Node& node, Claim& claim,
                                             const query::NamesReading& read) {
  auto series = query::read_series(node, read.names, read.subject, read.faults);
  if (!series) return std::nullopt;
  claim.comparison.unit = reduced_unit(claim.reduction, series->unit_text);
  series->formula.dimension = series->unit.dimension;
  return std::move(series->formula);
}

bool names_unit(const yaml::Node& node) {
  return node.is_scalar() && node.text.find(" in ") != std::string::npos;
}

/// Reads a number per run followed by its unit: `max(x) in mm`.
std::optional<query::Formula> read_of_run_with_unit(const yaml::Node& node, Claim& claim,
                                                    const query::NamesReading& read) {
  const std::size_t in = node.text.rfind(" in ");
  yaml::Node formula = node;
  formula.text.resize(in);
  auto value = read_of_run(formula, claim, read);
  const std::string text = node.text.substr(node.text.find_first_not_of(' ', in + 4));
  const auto unit = unit::parse_unit(text);
  if (!unit || !value) {
    if (!unit) read.fault(node.mark, fmt::format("'{}' is no unit", text));
    return std::nullopt;
  }
  query::check_dimension({0.0, unit->dimension, text, "the unit " + text},
                         {value->dimension, value->is_ratio}, "'" + formula.text + "'", node, read.names,
                         read.subject, read.faults);
  claim.comparison.unit = reduced_unit(claim.reduction, text);
  value->dimension = unit->dimension;
  return value;
}

/// Position in a text of a figure's quantity that is one number of each run, such as max(x).
struct DrawnNumber {
  std::size_t begin = 0;
  const query::NamedFormula* formula = nullptr;  ///< nullptr: there is none
};

DrawnNumber drawn_number_in(const std::string& text, const query::SymbolTable& names) {
  for (std::size_t i = 0; i < text.size();) {
    const std::string name = query::name_at(text, i);
    const auto found = std::ranges::find(names.drawn, name, &query::NamedFormula::name);
    if (found != names.drawn.end() && !names.find(name) && has_reduction(found->text)) return {i, &*found};
    i += std::max<std::size_t>(name.size(), 1);
  }
  return {};
}

/// Returns the value with the formulas of such quantities in place of their names.
yaml::Node with_drawn_numbers(yaml::Node node, const query::SymbolTable& names) {
  for (auto found = drawn_number_in(node.text, names); found.formula;
       found = drawn_number_in(node.text, names))
    node.text.replace(found.begin, found.formula->name.size(), "(" + found.formula->text + ")");
  return node;
}

std::optional<query::Formula> read_value(const yaml::Node& written, Claim& claim,
                                         const query::NamesReading& read) {
  const DrawnNumber number = written.is_scalar() ? drawn_number_in(written.text, read.names) : DrawnNumber{};
  if (number.formula && !is_of_runs(claim.reduction)) {
    read.fault(written.mark,
               fmt::format("'{0}' is one number of each run, {1}; a claim on it is of the runs, as "
                           "quantile_of_runs: {{share: 95 %, value: {0}}} or fraction_of_runs",
                           number.formula->name, number.formula->text));
    return std::nullopt;
  }
  const yaml::Node node = number.formula ? with_drawn_numbers(written, read.names) : written;
  if (is_of_runs(claim.reduction))
    return names_unit(node) ? read_of_run_with_unit(node, claim, read) : read_of_run(node, claim, read);
  return names_unit(node) ? read_with_unit(node, claim, read) : read.formula(node);
}

void add_value(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  auto value = read_value(node, claim, read);
  if (!value) return;
  const bool counts = claim.reduction == Reduction::fraction || claim.reduction == Reduction::count ||
                      claim.reduction == Reduction::fraction_of_runs;
  if (counts && names_unit(node) && claim.comparison.unit.empty())
    return read.fault(node.mark, fmt::format("'{}' is a condition, which has no unit; leave out '{}'",
                                             value->text, node.text.substr(node.text.rfind(" in ") + 1)));
  if (counts && value->dimension && *value->dimension != unit::Dimension{})
    return read.fault(node.mark,
                      fmt::format("'{}' is in {} and no condition; write what has to hold, such as '{} > 0'",
                                  node.text, unit::si_name(*value->dimension), node.text));
  claim.values.push_back(std::move(*value));
}

void read_model_and_measured(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  if (!node.is_list() || node.items.size() != 2) return read.fault(node.mark, "fit takes [MODEL, MEASURED]");
  for (const auto& item : node.items) add_value(item, claim, read);
  if (claim.values.size() != 2) return;
  const std::string other = query::compared_fault(claim.values[0], claim.values[1]);
  if (!other.empty()) read.fault(node.mark, other);
}

/// Reads a map of several keys; `time` and `share` are numbers, the other keys are formulas.
void read_two(const yaml::Node& node, const yaml::Key& form, Claim& claim, const query::NamesReading& read) {
  if (!read.check(node, form)) return;
  for (const yaml::Key& key : form.of) {
    const yaml::Node* value = node.find(key.name);
    if (value && key.name == "time")
      yaml::below(read, key.name).take(*value, key, claim.time);
    else if (value && key.name == "share")
      yaml::below(read, key.name).take(*value, key, claim.share);
    else if (value)
      add_value(*value, claim, yaml::below(read, key.name));
  }
}

ClaimRow reduction(Reduction kind, std::string name, std::string doc, yaml::Key form = form::expression()) {
  return yaml::one_of("reduction", ClaimRow{std::move(name), std::move(doc), form,
                                            [kind, form](Claim& claim, const yaml::Node& node,
                                                         const query::NamesReading& read) {
                                              claim.reduction = kind;
                                              if (kind == Reduction::fit)
                                                read_model_and_measured(node, claim, read);
                                              else if (form.form == yaml::Key::Form::keys)
                                                read_two(node, form, claim, read);
                                              else
                                                add_value(node, claim, read);
                                            }});
}

ClaimRow comparison(Comparison::Kind kind, std::string name, std::string sign, std::string doc) {
  return yaml::one_of("comparison",
                      ClaimRow{std::move(name), std::move(doc), form::computed(),
                               [=](Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
                                 claim.comparison.kind = kind;
                                 claim.comparison.low = read_compared(node, claim, read).value_or(0.0);
                                 claim.comparison.text = sign + " " + written_number(node, claim);
                               }});
}

/// Returns the row of a key beside `like`.
ClaimRow like_row(std::string name, std::string doc, yaml::Key form,
                  void (*set)(Likeness&, const yaml::Node&, const query::NamesReading&)) {
  return yaml::beside({"like"},
                      ClaimRow{std::move(name), std::move(doc), std::move(form),
                               [set](Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
                                 if (claim.like) set(*claim.like, node, read);
                               }});
}

void read_like(Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
  claim.reduction = Reduction::like;
  claim.comparison.kind = Comparison::Kind::at_most;
  claim.comparison.low = 1.0;
  claim.like = read_baseline(node, read);
}

void read_disagreement(Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
  if (claim.kind == Claim::Kind::invariant)
    return read.fault(node.mark, "an invariant always holds; what a source says stands under 'claims'");
  claim.disagrees = read.text(node);
}

yaml::Key two(std::string example, yaml::Key first, yaml::Key second) {
  return form::keys("it", std::move(example),
                    {yaml::needed(std::move(first)), yaml::needed(std::move(second))});
}

yaml::Key share_form() {
  yaml::Key share = form::computed();
  share.least = 0.0;
  share.most = 1.0;
  return share;
}

yaml::Key confidence_form() {
  yaml::Key confidence = form::computed();
  confidence.least = 0.5;
  confidence.most = 0.999999;
  return confidence;
}

std::vector<ClaimRow> claim_rows() {
  return {
      yaml::needed(ClaimRow{"that", "the statement, for people", form::text(), &Claim::that}),
      {"where", "only rows for which this is true count", form::expression(), &Claim::where},
      reduction(Reduction::final, "final",
                "its last value; over a sweep that of every run, of which the worst is shown"),
      reduction(Reduction::max, "max", "its largest value"),
      reduction(Reduction::min, "min", "its smallest value"),
      reduction(Reduction::mean, "mean", "its mean over time"),
      reduction(Reduction::rms, "rms", "its root mean square over time"),
      reduction(Reduction::spread, "spread", "its largest value minus its smallest"),
      reduction(Reduction::fraction, "fraction", "the share of rows where it is true, 0 to 1"),
      reduction(Reduction::count, "count", "how often it becomes true"),
      reduction(Reduction::at, "at", "its value at a time: {time: 2 s, value: x}",
                two("{time: 2 s, value: ...}", yaml::key("time", "when", form::computed("s")),
                    yaml::key("value", "what", form::expression()))),
      reduction(Reduction::quantile, "quantile",
                "what this share of its rows lies below, after Hazen: {share: 5 %, value: x}",
                two("{share: 5 %, value: ...}", yaml::key("share", "0 to 1, or in %", share_form()),
                    yaml::key("value", "what", form::expression()))),
      reduction(Reduction::rising, "rising",
                "rank correlation, 1 where it rises strictly: {value: x, over: y}",
                two("{value: ..., over: ...}", yaml::key("value", "what rises", form::expression()),
                    yaml::key("over", "with what", form::expression()))),
      reduction(Reduction::fit, "fit",
                "agreement of [MODEL, MEASURED] in percent: 100 (1 - |e| / |y - mean y|)",
                form::pair(form::expression())),
      reduction(
          Reduction::overshoot, "overshoot",
          "how far it goes beyond its last value, as a share of the way from its first to its last one"),
      reduction(Reduction::rise_time, "rise_time", "the time from 10 % to 90 % of that way"),
      reduction(Reduction::settling_time, "settling_time",
                "the time after which it stays within 2 % of that way about its last value"),
      reduction(Reduction::peak_time, "peak_time", "the time of its peak, since its first row"),
      reduction(Reduction::iae, "iae", "the integral of its absolute value over time: reference - y"),
      reduction(Reduction::steady_error, "steady_error",
                "the absolute value of its last value: reference - y"),
      reduction(Reduction::fraction_of_runs, "fraction_of_runs",
                "the share of the runs in which something holds of numbers of a run: max(x) < 2 mm"),
      reduction(Reduction::quantile_of_runs, "quantile_of_runs",
                "what this share of the runs lies below in a number of a run: {share: 95 %, value: max(x)}",
                two("{share: 95 %, value: max(x)}", yaml::key("share", "0 to 1, or in %", share_form()),
                    yaml::key("value", "what", form::expression()))),
      yaml::one_of(
          "reduction and comparison",
          ClaimRow{"like", "recorded signals that each run agrees with: baseline.csv; see within and jitter",
                   form::string(), read_like}),
      comparison(Comparison::Kind::equals, "equals", "=", "the reduced value is this; see within"),
      comparison(Comparison::Kind::at_most, "at_most", "<=", "the reduced value is this or less"),
      comparison(Comparison::Kind::at_least, "at_least", ">=", "the reduced value is this or more"),
      yaml::one_of("comparison",
                   ClaimRow{"between", "the reduced value lies in this interval: [3.1 N, 3.3 N]",
                            form::pair(form::computed()),
                            [](Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
                              claim.comparison.kind = Comparison::Kind::between;
                              read_between(node, claim, read);
                            }}),
      yaml::beside({"equals", "like"},
                   ClaimRow{"within", "tolerance of `equals` or `like`: 0.1 N, or relative: 1 %",
                            form::computed(), read_within}),
      like_row("jitter", "time by which an edge may be earlier or later than in the baseline",
               form::computed("s"), read_likeness_jitter),
      like_row("signals", "the compared signals of the baseline; without it all are",
               form::one_or_list(form::text()), read_likeness_signals),
      {"each_run",
       "true: judged for every run of a sweep, the worst is shown; always so for final, at, and what a step "
       "does",
       form::truth(), &Claim::each_run},
      yaml::beside({"fraction_of_runs", "quantile_of_runs"},
                   ClaimRow{"confidence",
                            "with which the comparison has to be satisfied: by the whole interval; without "
                            "it by the estimate alone, and the interval of 95 % is shown",
                            confidence_form(), &Claim::confidence}),
      yaml::beside({"fit"},
                   ClaimRow{"offset", "beside fit: the mean difference is no error", form::word({"free"}),
                            [](Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
                              claim.free_offset = read.word(node, form::word({"free"})).has_value();
                            }}),
      {"disagrees", "why a statement of the thesis is known not to hold", form::text(), read_disagreement}};
}

const yaml::KeyTable<Claim, query::NamesReading>& claim_table() {
  static const yaml::KeyTable<Claim, query::NamesReading> table(
      "a claim", "{that: ..., final: ..., equals: ...}", claim_rows());
  return table;
}

/// Checks a claim `like` without faults since `faults`, and sets its text.
Claim finished_likeness(Claim claim, std::size_t faults, const yaml::Node& node,
                        const query::NamesReading& read) {
  if (claim.like && read.faults.size() == faults) check_likeness(*claim.like, node, read);
  if (claim.like) claim.check = likeness_text(*claim.like);
  claim.each_run = true;
  return claim;
}

Claim read_claim(const yaml::Node& node, Claim::Kind kind, const query::NamesReading& read) {
  Claim claim;
  claim.kind = kind;
  claim.place = {read.names.file, node.mark};
  const std::size_t faults = read.faults.size();
  if (!claim_table().read(node, claim, read)) return claim;
  if (claim.reduction == Reduction::like) return finished_likeness(std::move(claim), faults, node, read);
  if (read.faults.size() == faults) check_can_fail(node, claim, read);
  claim.each_run = claim.each_run || claim.reduction == Reduction::final ||
                   claim.reduction == Reduction::at || is_of_step(claim.reduction);
  std::vector<const query::Formula*> all;
  for (const auto& value : claim.values)
    if (!claim.of_run) all.push_back(&value);
  if (claim.where) all.push_back(&*claim.where);
  const std::string& reduced = reduction_names()[static_cast<std::size_t>(claim.reduction)];
  claim.recording =
      query::common_recording(all, read.names, node, yaml::below(read, reduced).subject, read.faults);
  const yaml::Node* at = node.find("at");
  const yaml::Node* time = at ? at->find("time") : nullptr;
  claim.check = check_text(claim, time ? time->text : "");
  return claim;
}

}  // namespace

const yaml::Key& claim_form() {
  return claim_table().form;
}

std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::SymbolTable& names,
                               yaml::Faults& faults) {
  return read_claims(
      node, kind,
      query::NamesReading(kind == Claim::Kind::invariant ? "invariants" : "claims", names, faults));
}

std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::NamesReading& read) {
  std::vector<Claim> claims;
  if (!node.is_list())
    read.fault(node.mark, fmt::format("{} are a list: - {}", read.subject, claim_form().example));
  for (const auto& item : node.items) claims.push_back(read_claim(item, kind, read));
  return claims;
}

}  // namespace stepwire::claim
