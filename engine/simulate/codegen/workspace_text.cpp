#include "engine/simulate/codegen/workspace_text.hpp"

#include <fmt/format.h>

namespace stepwire::codegen {

std::string places_text(const plan::Plan& plan, const PlaceNames& names) {
  std::string text = "/// Where each number of the workspace lies.\nnamespace at {\nenum : int {\n";
  for (const NamedPlace& place : names.places())
    text += fmt::format("  {} = {},  // {}\n", place.name, place.offset, place.meaning);
  text += "};\n}  // namespace at\n\n";
  return text + fmt::format(
                    "[[maybe_unused]] constexpr double step = {};  // [s]\n"
                    "[[maybe_unused]] constexpr int states = {}, first_derivative = {};  // where the first "
                    "state and slope lie\n"
                    "constexpr int size = {};  // of the workspace\n\n",
                    number_text(plan.diagram.step), plan.layout.states, plan.layout.derivatives,
                    plan.layout.size);
}

std::string tables_text(const Literals& literals) {
  std::string text;
  if (const std::string tables = literals.tables(); !tables.empty())
    text +=
        "/// Lists of numbers that blocks read.\nnamespace table {\n" + tables + "}  // namespace table\n\n";
  if (const std::string functions = literals.functions(); !functions.empty())
    text += "/// Formulas of blocks.\nnamespace formula {\n" + functions + "}  // namespace formula\n\n";
  return text;
}

std::string time_text(const plan::Plan& plan, const std::string& tick) {
  const TickTimes& times = plan.tick_times;
  const std::string product = fmt::format("static_cast<double>({}) * {}", tick, number_text(times.numerator));
  return times.denominator == 1.0 ? product : product + " / " + number_text(times.denominator);
}

std::string period_text(const plan::Plan& plan, std::size_t block) {
  const double period = plan.time_of(plan.blocks[block].rate.ticks);
  const TickTimes times = tick_times(period);
  return fmt::format("{}, {{{}, {}}}", number_text(period), number_text(times.numerator),
                     number_text(times.denominator));
}

std::string numbers_parameter(const LanePlaces& lanes, const std::string& name) {
  return (lanes.lanes > 1 ? "[[maybe_unused]] Lanes " : "[[maybe_unused]] double* ") + name;
}

std::string workspace_parameters(const LanePlaces& lanes) {
  return numbers_parameter(lanes, "w") + ", [[maybe_unused]] " +
         (lanes.lanes > 1 ? "LaneNumbers" : "const double*") + " numbers";
}

std::string given_slope_text(const plan::Plan& plan, const LanePlaces& lanes, std::size_t place) {
  const std::size_t i = place - plan.layout.derivatives;
  if (lanes.lanes == 1 || !lanes.places[place])
    return fmt::format("  dot[{0}] = w[first_derivative + {0}];\n", i);
  return fmt::format(
      "  for (int l = 0; l < lanes; ++l) dot.lane(l)[{0}] = w.lane(l)[first_derivative + {0}];\n", i);
}

}  // namespace stepwire::codegen
