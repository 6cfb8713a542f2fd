#include "blocks/hardware/sensor.hpp"

#include <fmt/format.h>

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

namespace {

bool unbounded(const PerElement& lower, const PerElement& upper) {
  return std::any_of(lower.begin(), lower.end(), [](double limit) { return !std::isfinite(limit); }) ||
         std::any_of(upper.begin(), upper.end(), [](double limit) { return !std::isfinite(limit); });
}

std::string level_text(const Sensor& sensor) {
  return sensor.bits > 0 ? fmt::format("a converter of {} bits", sensor.bits) : "no converter (bits: 0)";
}

}  // namespace

void Sensor::configure(Configure& is) {
  require_order<&Sensor::lower, &Sensor::upper>(*this, is);
  if (!all_are(linearity, 0.0) && unbounded(lower, upper))
    is.refuse<&Sensor::linearity>("is a share of the range; it needs both 'lower' and 'upper'");
  if ((bits > 0) == all_are(converter_range, 0.0))
    is.refuse<&Sensor::bits>(fmt::format(
        "{} does not go with this 'converter_range'; give both, or none of them", level_text(*this)));
}

void Sensor::declare(Declare<Sensor>& is) {
  is.block(
      "Sensor",
      {.doc = "An analogue sensor and the converter that reads it: range, linearity, noise and steps of "
              "the converter. It samples at its ticks (`every`). Left out, a parameter does nothing, and a "
              "sensor without any shows what it is fed. The same seed gives the same noise on every "
              "machine.",
       .source = "thesis 2.4, 3.3; datasheets of the presets, see there for what is assumed",
       .timing = Timing::discrete,
       .at_end = true});
  is.parameter<&Sensor::zero>(
      {.unit = "'u", .doc = "input at which the sensor itself shows 0: its mounting"});
  is.parameter<&Sensor::lower>({.unit = "'u", .doc = "lowest value, from zero; the sensor stays there"});
  is.parameter<&Sensor::upper>({.unit = "'u", .doc = "highest value, from zero; the sensor stays there"});
  is.parameter<&Sensor::linearity>(
      {.doc =
           "largest deviation from the straight line as a share of the range: a sine over the range, right "
           "at its ends and in its middle (assumed)",
       .below = 0.15,
       .at_least = 0.0});
  is.parameter<&Sensor::noise>(
      {.unit = "delta 'u", .doc = "standard deviation of normal noise", .at_least = 0.0});
  is.parameter<&Sensor::converter_range>(
      {.unit = "delta 'u",
       .doc = "what the whole range of the converter, of all its levels, measures",
       .at_least = 0.0});
  is.parameter<&Sensor::bits>({.doc = "of the converter; 0: no converter", .at_least = 0.0, .at_most = 32.0});
  is.parameter<&Sensor::seed>({.doc = "which sequence of noise; a whole number", .required = true});
  is.input<&Sensor::u>({.unit = "'u", .doc = "what is measured"});
  is.output<&Sensor::y>({.unit = "'u", .doc = "what is read"});
  is.state<&Sensor::sample>({.doc = "number of the sample", .settable = false});
  is.diagnostic<&Sensor::out_of_range>(
      {.doc = "what is measured leaves the sensor's range; it shows the end of it"});
  is.clock<&Sensor::time>();
  is.prepared<&Sensor::interval>();
  is.preset<celesco_mlp_75>("celesco-mlp-75", "string potentiometer of 75 mm, in m; 'zero' is its mounting");
  is.preset<ati_mini40_si_80_4>("ati-mini40-si-80-4", "load cell, x and y of 80 N, in N");
  is.preset<ati_mini40_si_40_2>("ati-mini40-si-40-2", "load cell, x and y of 40 N, in N");
}

}  // namespace stepwire
