#include "engine/analyse/claim/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/analyse/claim/reduced_value.hpp"
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

/// Returns the milli unit of m, m/s and J for values below 1, else the SI unit.
std::string handy(const std::string& si, double value) {
  if (std::abs(value) >= 1.0) return si;
  if (si == "m" || si == "m/s" || si == "J") return "m" + si;
  return si;
}

/// Returns the first unit of this dimension and meaning after a number in a sentence: "mm" in "it ends at 5
/// mm". Empty if there is none.
std::string unit_in(const std::string& sentence, const unit::Dimension& dimension) {
  constexpr std::string_view marks = ",;:.!?()";
  for (std::size_t at = sentence.find(' '); at != std::string::npos; at = sentence.find(' ', at + 1)) {
    if (at == 0 || !std::isdigit(static_cast<unsigned char>(sentence[at - 1]))) continue;
    for (std::size_t end = sentence.size(); end > at + 1; end = sentence.rfind(' ', end - 1)) {
      std::string word = sentence.substr(at + 1, end - at - 1);
      while (!word.empty() && marks.find(word.back()) != marks.npos) word.pop_back();
      const auto unit = word.empty() ? std::nullopt : unit::parse_unit(word);
      if (unit && unit->dimension == dimension && unit::other_meaning(unit->dimension, dimension).empty())
        return word;
    }
  }
  return {};
}

std::string unit_of(const Claim& claim, double value) {
  if (claim.reduction == Reduction::fit) return "%";
  if (!claim.comparison.unit.empty()) return claim.comparison.unit;
  const auto dimension = reduced_dimension(claim);
  if (!dimension || *dimension == unit::Dimension{}) return "";
  const std::string written = unit_in(claim.that, *dimension);
  return written.empty() ? handy(unit::si_name(*dimension), value) : written;
}

/// Replaces a negligible value by 0 if that is on the same side of the bound. Negligible is below the
/// rounding error of `magnitude` and below 1 % of the bound.
double resolved(const Comparison& comparison, double value, double magnitude) {
  constexpr double resolution = 1e-12, part_of_bound = 0.01;
  const double bound = std::max({std::abs(comparison.low), std::abs(comparison.high), comparison.within});
  const double unseen = std::min(resolution * std::max(magnitude, bound), part_of_bound * bound);
  const bool alike = (comparison.margin(0.0) >= 0.0) == (comparison.margin(value) >= 0.0);
  return alike && std::abs(value) <= unseen ? 0.0 : value;
}

/// Returns the nearest number of four digits on the correct side of the comparison; with more digits if there
/// is none.
std::string holding_number(const Comparison& comparison, double value, const unit::Unit& unit) {
  const double in_unit = unit.from_si(value);
  const double step = in_unit == 0.0 ? 0.0 : std::pow(10.0, std::floor(std::log10(std::abs(in_unit))) - 3.0);
  for (int digits = 4; digits <= 17; ++digits)
    for (const double moved : {0.0, -step, step}) {
      const std::string text = query::short_number(in_unit + (digits == 4 ? moved : 0.0), digits);
      if (comparison.margin(unit.to_si(std::strtod(text.c_str(), nullptr))) >= 0.0) return text;
    }
  return query::short_number(in_unit, 17);
}

}  // namespace

double Comparison::margin(double value) const {
  if (std::isnan(value)) return -std::numeric_limits<double>::infinity();
  switch (kind) {
    case Kind::at_most:
      return low - value;
    case Kind::at_least:
      return value - low;
    case Kind::between:
      return std::min(value - low, high - value);
    case Kind::equals:
      break;
  }
  // The difference of equal infinities is nan; it counts as 0.
  return value == low ? within : within - std::abs(value - low);
}

std::string Verdict::word() const {
  if (disagrees.empty()) return holds ? "holds" : "does not hold";
  return holds ? "holds after all" : "does not hold (known)";
}

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
  return reduced_dimension(claim.reduction,
                           claim.values.empty() ? std::nullopt : claim.values.front().dimension);
}

std::optional<unit::Dimension> difference_dimension(const Claim& claim) {
  auto dimension = reduced_dimension(claim);
  if (dimension && unit::is_temperature(*dimension)) dimension->zeros = 0.0;
  return dimension;
}

std::string check_text(const Claim& claim, const std::string& time) {
  const bool pair = claim.reduction == Reduction::rising || claim.reduction == Reduction::fit;
  if (claim.values.size() != (pair ? 2u : 1u)) return {};
  std::string text = reduction_text(claim, time) + " " + claim.comparison.text;
  if (claim.where) text += " where " + claim.where->text;
  if (claim.confidence) text += fmt::format(" at {:g} % confidence", 100.0 * *claim.confidence);
  return text;
}

std::string value_text(const Claim& claim, double exact, double magnitude) {
  const double value = resolved(claim.comparison, exact, magnitude);
  const std::string name = unit_of(claim, value);
  const unit::Unit unit =
      claim.reduction == Reduction::fit ? unit::Unit{} : unit::parse_unit(name).value_or(unit::Unit{});
  const bool holds = claim.comparison.margin(value) >= 0.0;
  const bool is_plain = holds && claim.comparison.kind == Comparison::Kind::equals;
  std::string text = query::short_number(unit.from_si(value));
  if (holds && !is_plain && std::isfinite(value)) text = holding_number(claim.comparison, value, unit);
  for (int digits = 5; !holds && std::isfinite(value) && digits <= 17; ++digits) {
    if (claim.comparison.margin(unit.to_si(std::strtod(text.c_str(), nullptr))) < 0.0) break;
    text = query::short_number(unit.from_si(value), digits);
  }
  return name.empty() ? text : text + " " + name;
}

}  // namespace stepwire::claim
