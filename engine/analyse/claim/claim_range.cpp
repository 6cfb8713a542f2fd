#include "engine/analyse/claim/claim_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/claim/claim_words.hpp"

namespace stepwire::claim {
namespace {

/// Range of the numbers that a reduction can return for any input; infinite where unbounded.
struct ReducedRange {
  double least, most;
};

/// True if a comparison accepts every number of a range.
bool accepts(const Comparison& comparison, const ReducedRange& range) {
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

ReducedRange reduced_range(Reduction reduction) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (reduction) {
    case Reduction::fraction:
    case Reduction::fraction_of_runs:
      return {0.0, 1.0};
    case Reduction::rising:
      return {-1.0, 1.0};
    case Reduction::count:
    case Reduction::rms:
    case Reduction::spread:
    case Reduction::overshoot:
    case Reduction::rise_time:
    case Reduction::settling_time:
    case Reduction::peak_time:
    case Reduction::iae:
    case Reduction::steady_error:
      return {0.0, infinity};
    case Reduction::fit:
      return {-infinity, 100.0};
    default:
      return {-infinity, infinity};
  }
}

/// True for a formula that reads nothing of the run. Parameters count as part of the run, since they may be
/// fitted. So do the values of figures, scenes and blocks: a claim about them can fail.
bool names_nothing(const query::Formula& formula, const query::SymbolTable& names) {
  return formula.columns.empty() && formula.text.find('$') == std::string::npos &&
         std::ranges::none_of(names.drawn, [&](const query::NamedFormula& one) {
           return formula.text.find(one.name) != std::string::npos;
         });
}

std::string range_text(const ReducedRange& range) {
  if (!std::isfinite(range.most)) return fmt::format("is {:g} or more", range.least);
  if (!std::isfinite(range.least)) return fmt::format("is {:g} or less", range.most);
  return fmt::format("lies between {:g} and {:g}", range.least, range.most);
}

/// Returns advice on a bound with which the claim can fail.
std::string failing_limit(Comparison::Kind kind, const ReducedRange& range) {
  switch (kind) {
    case Comparison::Kind::at_least:
      return fmt::format("give a number above {:g}", range.least);
    case Comparison::Kind::at_most:
      return fmt::format("give a number below {:g}", range.most);
    default:
      return "leave out a part of that range";
  }
}

}  // namespace

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
  const ReducedRange range = reduced_range(claim.reduction);
  if (accepts(claim.comparison, range))
    yaml::below(read, compared)
        .fault(node.find(compared)->mark,
               fmt::format("'{}' {}, so that this cannot fail; {}", reduced, range_text(range),
                           failing_limit(claim.comparison.kind, range)));
}

}  // namespace stepwire::claim
