#include "engine/figure/claim_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/figure/number.hpp"

namespace stepwire {
namespace {

std::string reduction_text(const Claim& claim, const std::string& time) {
  const auto& values = claim.values;
  switch (claim.reduction) {
    case Reduction::at:
      return fmt::format("{} at {}", values[0].text, time);
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

std::string unit_of(const Claim& claim) {
  if (claim.reduction == Reduction::fit) return "%";
  if (!claim.comparison.unit.empty()) return claim.comparison.unit;
  const auto dimension = reduced_dimension(claim);
  if (!dimension || *dimension == Dimension{}) return "";
  return si_name(*dimension);
}

}  // namespace

const std::vector<std::string>& reduction_names() {
  static const std::vector<std::string> names{"final",    "max",   "min", "mean",   "rms", "spread",
                                              "fraction", "count", "at",  "rising", "fit"};
  return names;
}

Reduction reduction_named(const std::string& name) {
  const auto& names = reduction_names();
  return static_cast<Reduction>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::optional<Dimension> reduced_dimension(const Claim& claim) {
  switch (claim.reduction) {
    case Reduction::fraction:
    case Reduction::count:
    case Reduction::rising:
    case Reduction::fit:
      return Dimension{};
    default:
      return claim.values.empty() ? std::nullopt : claim.values.front().dimension;
  }
}

std::string check_text(const Claim& claim, const std::string& time) {
  const bool pair = claim.reduction == Reduction::rising || claim.reduction == Reduction::fit;
  if (claim.values.size() != (pair ? 2u : 1u)) return {};
  std::string text = reduction_text(claim, time) + " " + claim.comparison.text;
  if (claim.where) text += " where " + claim.where->text;
  return text;
}

std::string value_text(const Claim& claim, double value) {
  const std::string name = unit_of(claim);
  const Unit unit = claim.reduction == Reduction::fit ? Unit{} : parse_unit(name).value_or(Unit{});
  const bool holds = claim.comparison.margin(value) >= 0.0;
  std::string text;
  for (int digits = 4; digits <= 17; ++digits) {
    text = short_number(unit.from_si(value), digits);
    const double shown = unit.to_si(std::strtod(text.c_str(), nullptr));
    if (!std::isfinite(value) || (claim.comparison.margin(shown) >= 0.0) == holds) break;
  }
  return name.empty() ? text : text + " " + name;
}

}  // namespace stepwire
