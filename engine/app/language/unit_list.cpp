#include "engine/app/language/unit_list.hpp"

#include <algorithm>

namespace stepwire::language {

namespace {

/// Returns the most common units in engineering, with their quantities.
const std::vector<KnownUnit>& usual() {
  static const std::vector<KnownUnit> all{{"s", "time"},
                                          {"ms", "time"},
                                          {"us", "time"},
                                          {"min", "time"},
                                          {"m", "length"},
                                          {"mm", "length"},
                                          {"cm", "length"},
                                          {"um", "length"},
                                          {"kg", "mass"},
                                          {"g", "mass"},
                                          {"N", "force"},
                                          {"mN", "force"},
                                          {"kN", "force"},
                                          {"N m", "torque"},
                                          {"N mm", "torque"},
                                          {"J", "energy"},
                                          {"W", "power"},
                                          {"kW", "power"},
                                          {"m/s", "speed"},
                                          {"mm/s", "speed"},
                                          {"m/s^2", "acceleration"},
                                          {"rad", "angle"},
                                          {"deg", "angle"},
                                          {"rad/s", "angular speed"},
                                          {"deg/s", "angular speed"},
                                          {"Hz", "frequency"},
                                          {"kHz", "frequency"},
                                          {"N/m", "stiffness"},
                                          {"N/mm", "stiffness"},
                                          {"N s/m", "damping"},
                                          {"N/s", "rate of a force"},
                                          {"N m/rad", "torsional stiffness"},
                                          {"A", "current"},
                                          {"mA", "current"},
                                          {"V", "voltage"},
                                          {"mV", "voltage"},
                                          {"ohm", "resistance"},
                                          {"kohm", "resistance"},
                                          {"H", "inductance"},
                                          {"mH", "inductance"},
                                          {"F", "capacitance"},
                                          {"uF", "capacitance"},
                                          {"T", "flux density"},
                                          {"Wb", "magnetic flux"},
                                          {"Pa", "pressure"},
                                          {"kPa", "pressure"},
                                          {"bar", "pressure"},
                                          {"K", "temperature"},
                                          {"degC", "temperature"},
                                          {"%", "ratio"},
                                          {"kg m^2", "moment of inertia"},
                                          {"m^2", "area"},
                                          {"m^3", "volume"},
                                          {"m^3/s", "flow"},
                                          {"kg/m^3", "density"},
                                          {"V s/rad", "motor constant"}};
  return all;
}

}  // namespace

std::vector<KnownUnit> units_of(const std::optional<unit::Dimension>& dimension) {
  if (!dimension) return usual();
  std::vector<KnownUnit> fitting;
  for (const KnownUnit& unit : usual())
    if (const auto parsed = unit::parse_unit(unit.name); parsed && parsed->dimension == *dimension)
      fitting.push_back(unit);
  const std::string si = unit::si_name(*dimension);
  if (*dimension != unit::Dimension{} && std::ranges::find(fitting, si, &KnownUnit::name) == fitting.end())
    fitting.push_back({si, "SI"});
  return fitting;
}

}  // namespace stepwire::language
