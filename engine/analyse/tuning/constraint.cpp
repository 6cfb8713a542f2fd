#include "engine/analyse/tuning/constraint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::tuning {

namespace {

using claim::Comparison;
using claim::Reduction;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// True for a formula whose value is true or false, by its operators or as the `stable` of an analysis.
bool is_truth(const query::Formula& formula, const std::vector<linear::NamedAnalysis>& linear) {
  if (formula.expression.cpp() == formula.expression.cpp_condition()) return true;
  return std::ranges::any_of(linear, [&](const linear::NamedAnalysis& analysis) {
    return formula.text == analysis.name + ".stable";
  });
}

void check(const claim::Claim& claim, const std::vector<linear::NamedAnalysis>& linear,
           const yaml::Node& node, const query::NamesReading& read) {
  if (claim.reduction == Reduction::like)
    return read.fault(
        node.mark,
        "compares a run with a file, which no search follows; 'like' is a key of 'claims', and a "
        "bound of a number is one here: 'max: abs(x), at_most: 2 mm'");
  const bool shares = claim.reduction == Reduction::fraction || claim.reduction == Reduction::count ||
                      claim.reduction == Reduction::rising;
  if (!shares &&
      std::ranges::any_of(claim.values, [&](const auto& value) { return is_truth(value, linear); }))
    return read.fault(node.mark,
                      "is true or false and gives no margin; hold a number against a bound, as in "
                      "'max: abs(x), at_most: 2 mm'");
  if (room_of(claim.comparison) == 0.0)
    return read.fault(node.mark, "leaves no room; give 'within', or a bound at one side");
  if (!claim.disagrees.empty()) read.fault(node.mark, "is to hold, so it has no 'disagrees'");
}

}  // namespace

std::vector<claim::Claim> read_constraints(const yaml::Node& node,
                                           const std::vector<linear::NamedAnalysis>& linear,
                                           const query::NamesReading& read) {
  const std::size_t before = read.faults.size();
  std::vector<claim::Claim> claims = claim::read_claims(node, claim::Claim::Kind::statement, read);
  if (read.faults.size() != before) return {};
  for (std::size_t i = 0; i < claims.size(); ++i) check(claims[i], linear, node.items[i], read);
  return claims;
}

std::vector<double> sides_of(const Comparison& comparison, double value) {
  const bool is_one =
      comparison.kind == Comparison::Kind::at_most || comparison.kind == Comparison::Kind::at_least;
  if (is_one) return {comparison.margin(value)};
  if (std::isnan(value)) return {-infinity, -infinity};
  const bool is_near = comparison.kind == Comparison::Kind::equals;
  const double low = is_near ? comparison.low - comparison.within : comparison.low;
  const double high = is_near ? comparison.low + comparison.within : comparison.high;
  return {value - low, high - value};
}

double scale_of(const Comparison& comparison, double value) {
  const bool two = comparison.kind == Comparison::Kind::between;
  const double bound = std::max(std::abs(comparison.low), two ? std::abs(comparison.high) : 0.0);
  if (bound > 0.0 && std::isfinite(bound)) return bound;
  return std::isfinite(value) && value != 0.0 ? std::abs(value) : 1.0;
}

double room_of(const Comparison& comparison) {
  if (comparison.kind == Comparison::Kind::equals) return 2.0 * comparison.within;
  return comparison.kind == Comparison::Kind::between ? comparison.high - comparison.low : infinity;
}

}  // namespace stepwire::tuning
