#include "engine/analyse/claim/claim_comparison.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/analyse/claim/claim_words.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"

namespace stepwire::claim {

namespace {

/// Adds a fault unless a number has the unit of the claim's value, or both are in SI.
void check_unit(const query::WantedNumber& number, const yaml::Node& node, const Claim& claim,
                const std::optional<unit::Dimension>& dimension, const query::NamesReading& read) {
  query::check_dimension(number, dimension, "the claim's value", node, read.names, read.subject, read.faults);
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
void refuse_bare(const query::WantedNumber& number, const yaml::Node& node, const Claim& claim,
                 const query::NamesReading& read) {
  const auto shown = unit::parse_unit(claim.comparison.unit);
  const bool is_bare = !number.dimension && number.value != 0.0 && unit::parse_quantity(node.text);
  if (is_bare && shown && claim.comparison.unit != "%" && (shown->scale != 1.0L || shown->offset != 0.0L))
    read.fault(node.mark, fmt::format("{0} has no unit, but the value is in {1}; write {0} {1}", node.text,
                                      claim.comparison.unit));
}

}  // namespace

std::optional<double> read_compared(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  auto number = query::read_number(node, read.names, read.subject, read.faults);
  if (!number) return std::nullopt;
  if (claim.reduction == Reduction::fit && number->unit == "%") return 100.0 * number->value;
  check_unit(*number, node, claim, reduced_dimension(claim), read);
  if (claim.comparison.unit.empty())
    claim.comparison.unit = number->unit;
  else
    refuse_bare(*number, node, claim, read);
  return number->value;
}

std::string written_number(const yaml::Node& node, const Claim& claim) {
  const auto number = unit::parse_quantity(node.text);
  const auto dimension = reduced_dimension(claim);
  if (!number || number->dimension || !dimension || *dimension == unit::Dimension{}) return node.text;
  return node.text + " " + unit::si_name(*dimension);
}

void read_between(const yaml::Node& node, Claim& claim, const query::NamesReading& read) {
  const auto* ends = read.pair(node, yaml::like("[3.1 N, 3.3 N]", {}));
  if (!ends) return;
  const yaml::Node &first = ends->front(), &second = ends->back();
  const auto low = read_compared(first, claim, read), high = read_compared(second, claim, read);
  if (low && high && *low > *high)
    read.fault(node.mark,
               fmt::format("{} is above {}; the smaller number comes first", first.text, second.text));
  claim.comparison.low = low.value_or(0.0);
  claim.comparison.high = high.value_or(0.0);
  claim.comparison.text =
      fmt::format("between {} and {}", written_number(first, claim), written_number(second, claim));
}

void read_within(Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
  Comparison& comparison = claim.comparison;
  const auto number = query::read_number(node, read.names, read.subject, read.faults);
  if (!number || comparison.kind != Comparison::Kind::equals) return;
  const bool relative = number->unit == "%";
  if (!relative) check_unit(*number, node, claim, difference_dimension(claim), read);
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

}  // namespace stepwire::claim
