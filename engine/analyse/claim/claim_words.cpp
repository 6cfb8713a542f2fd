#include "engine/analyse/claim/claim_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/analyse/query/number.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::claim {
namespace {

std::string reduction_text(const Claim& claim, const std::string& time) {
  const auto& values = claim.values;
  switch (claim.reduction) {
    case Reduction::at:
      return fmt::format("{} at {}", values[0].text, time);
    case Reduction::quantile:
      return fmt::format("{:g} % quantile of {}", 100.0 * claim.share, values[0].text);
    case Reduction::fraction_of_runs:
      return fmt::format("fraction of runs in which {}", values[0].text);
    case Reduction::quantile_of_runs:
      return fmt::format("{:g} % quantile over runs of {}", 100.0 * claim.share, values[0].text);
    case Reduction::rising:
      return fmt::format("rising {} over {}", values[0].text, values[1].text);
    case Reduction::fit:
      return fmt::format("fit {} to {}{}", values[0].text, values[1].text,
                         claim.free_offset ? " with a free offset" : "");
    default:
      return fmt::format("{} {}", reduction_names()[static_cast<std::size_t>(claim.reduction)],
                         values[0].text);
  }
}

/// The unit of small values where the author gives none.
std::string handy(const std::string& si, double value) {
  if (std::abs(value) >= 1.0) return si;
  if (si == "m" || si == "m/s" || si == "J") return "m" + si;
  return si;
}

std::string unit_of(const Claim& claim, double value) {
  if (claim.reduction == Reduction::fit) return "%";
  if (!claim.comparison.unit.empty()) return claim.comparison.unit;
  const auto dimension = reduced_dimension(claim);
  if (!dimension || *dimension == unit::Dimension{}) return "";
  return handy(unit::si_name(*dimension), value);
}

/// 0 where the value is no more than the rounding of what it was made of, if that is on the same side.
double resolved(const Comparison& comparison, double value, double magnitude) {
  constexpr double resolution = 1e-12;
  const double scale = std::max({magnitude, std::abs(comparison.low), std::abs(comparison.high)});
  const bool alike = (comparison.margin(0.0) >= 0.0) == (comparison.margin(value) >= 0.0);
  return alike && std::abs(value) <= resolution * scale ? 0.0 : value;
}

std::optional<unit::Dimension> value_dimension(const Claim& claim) {
  return claim.values.empty() ? std::nullopt : claim.values.front().dimension;
}

std::optional<unit::Dimension> as_difference(std::optional<unit::Dimension> dimension) {
  if (dimension && unit::is_temperature(*dimension)) dimension->zeros = 0.0;
  return dimension;
}

}  // namespace

const std::vector<std::string>& reduction_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const yaml::Key& key : claim_form().of)
      if (key.choice == "reduction") found.push_back(key.name);
    return found;
  }();
  return names;
}

std::optional<unit::Dimension> reduced_dimension(const Claim& claim) {
  switch (claim.reduction) {
    case Reduction::fraction:
    case Reduction::fraction_of_runs:
    case Reduction::count:
    case Reduction::rising:
    case Reduction::fit:
    case Reduction::overshoot:
      return unit::Dimension{};
    case Reduction::rise_time:
    case Reduction::settling_time:
    case Reduction::peak_time:
      return unit::parse_unit("s")->dimension;
    case Reduction::iae:
      if (claim.values.empty() || !claim.values.front().dimension) return std::nullopt;
      return *claim.values.front().dimension * unit::parse_unit("s")->dimension;
    case Reduction::spread:
    case Reduction::rms:
      return as_difference(value_dimension(claim));
    default:
      return value_dimension(claim);
  }
}

std::optional<unit::Dimension> difference_dimension(const Claim& claim) {
  return as_difference(reduced_dimension(claim));
}

std::string check_text(const Claim& claim, const std::string& time) {
  const bool pair = claim.reduction == Reduction::rising || claim.reduction == Reduction::fit;
  if (claim.values.size() != (pair ? 2u : 1u)) return {};
  std::string text = reduction_text(claim, time) + " " + claim.comparison.text;
  if (claim.where) text += " where " + claim.where->text;
  if (claim.confidence) text += fmt::format(" with {:g} %", 100.0 * *claim.confidence);
  return text;
}

std::string value_text(const Claim& claim, double exact, double magnitude) {
  const double value = resolved(claim.comparison, exact, magnitude);
  const std::string name = unit_of(claim, value);
  const unit::Unit unit =
      claim.reduction == Reduction::fit ? unit::Unit{} : unit::parse_unit(name).value_or(unit::Unit{});
  const bool holds = claim.comparison.margin(value) >= 0.0;
  const bool is_plain = holds && claim.comparison.kind == Comparison::Kind::equals;
  std::string text;
  for (int digits = 4; digits <= (is_plain ? 4 : 17); ++digits) {
    text = query::short_number(unit.from_si(value), digits);
    const double shown = unit.to_si(std::strtod(text.c_str(), nullptr));
    if (!std::isfinite(value) || (claim.comparison.margin(shown) >= 0.0) == holds) break;
  }
  return name.empty() ? text : text + " " + name;
}

}  // namespace stepwire::claim
