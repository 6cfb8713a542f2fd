#include "engine/analyse/claim/reduced_value.hpp"

#include <array>
#include <limits>

#include "engine/base/unit/meaning.hpp"

namespace stepwire::claim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ReducedValue any_value{ReducedKind::value, -infinity, infinity},
    distance{ReducedKind::difference, 0.0, infinity}, time_of_step{ReducedKind::time, 0.0, infinity};

// In the order of `Reduction`.
constexpr std::array<ReducedValue, 21> reduced_values{{
    any_value,                                  // final
    any_value,                                  // max
    any_value,                                  // min
    any_value,                                  // mean
    distance,                                   // rms
    distance,                                   // spread
    {ReducedKind::share, 0.0, 1.0},             // fraction
    {ReducedKind::number, 0.0, infinity},       // count
    any_value,                                  // at
    any_value,                                  // quantile
    {ReducedKind::number, -1.0, 1.0},           // rising
    {ReducedKind::percent, -infinity, 100.0},   // fit
    {ReducedKind::share, 0.0, infinity},        // overshoot
    time_of_step,                               // rise_time
    time_of_step,                               // settling_time
    time_of_step,                               // peak_time
    {ReducedKind::integral, 0.0, infinity},     // iae
    distance,                                   // steady_error
    {ReducedKind::share, 0.0, 1.0},             // fraction_of_runs
    any_value,                                  // quantile_of_runs
    {ReducedKind::number, -infinity, infinity}  // like
}};
static_assert(reduced_values.size() == static_cast<std::size_t>(Reduction::like) + 1);

unit::Dimension second() {
  return unit::parse_unit("s")->dimension;
}

std::optional<unit::Dimension> as_difference(std::optional<unit::Dimension> dimension) {
  if (dimension && unit::is_temperature(*dimension)) dimension->zeros = 0.0;
  return dimension;
}

std::string unit_of_integral(const std::string& unit) {
  if (unit.empty()) return "";
  const std::string product = unit == "1" ? "s" : unit_of_difference(unit) + " s";
  return unit::parse_unit(product) ? product : "";
}

}  // namespace

const ReducedValue& reduced_value(Reduction reduction) {
  return reduced_values[static_cast<std::size_t>(reduction)];
}

std::optional<unit::Dimension> reduced_dimension(Reduction reduction,
                                                 const std::optional<unit::Dimension>& signal) {
  switch (reduced_value(reduction).kind) {
    case ReducedKind::value:
      return signal;
    case ReducedKind::difference:
      return as_difference(signal);
    case ReducedKind::integral:
      return signal ? std::optional(*signal * second()) : std::nullopt;
    case ReducedKind::time:
      return second();
    default:
      return unit::Dimension{};
  }
}

std::string unit_of_difference(const std::string& unit) {
  const auto parsed = unit::parse_unit(unit);
  if (!parsed || parsed->offset == 0.0L) return unit;
  return parsed->scale == 1.0L ? "K" : "delta_" + unit;
}

std::string reduced_unit(Reduction reduction, const std::string& signal_unit) {
  switch (reduced_value(reduction).kind) {
    case ReducedKind::value:
      return signal_unit;
    case ReducedKind::difference:
      return unit_of_difference(signal_unit);
    case ReducedKind::integral:
      return unit_of_integral(signal_unit);
    case ReducedKind::time:
      return "s";
    case ReducedKind::share:
      return signal_unit == "%" ? signal_unit : "";
    default:
      return "";
  }
}

bool is_ratio(const Claim& claim) {
  const ReducedKind kind = reduced_value(claim.reduction).kind;
  if (kind == ReducedKind::value || kind == ReducedKind::difference)
    return !claim.values.empty() && claim.values.front().is_ratio;
  return kind == ReducedKind::share || kind == ReducedKind::number || kind == ReducedKind::percent;
}

}  // namespace stepwire::claim
