#include "blocks/hardware/load_cell.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void LoadCell::configure(Configure& is) {
  if (const char* problem = calibration_problem(calibration)) is.refuse<&LoadCell::calibration>(problem);
  is.size("g", 6);
}

void LoadCell::prepare() {
  response = inverse_of(calibration);
}

void LoadCell::declare(Declare<LoadCell>& is) {
  is.block("LoadCell",
           {.doc = "A six-axis load cell with its amplifier: a force and a torque become the voltages of six "
                   "pairs of strain gauges, by the inverse of the calibration that comes with the cell, with "
                   "offset and noise; beyond their range they stay at its end. It samples at its ticks "
                   "(`every`). LoadCellToWrench is the way back.",
            .source = "thesis 3.2; datasheet of the ATI Mini40",
            .timing = Timing::discrete,
            .at_end = true});
  is.parameter<&LoadCell::calibration>(
      {.shape = "6 x 6", .doc = "rows [Fx, Fy, Fz, Tx, Ty, Tz] in N and N m, for a volt of each gauge"});
  is.parameter<&LoadCell::offset>({.unit = "V", .shape = "g", .doc = "what the gauges show without a load"});
  is.parameter<&LoadCell::noise>(
      {.unit = "V", .shape = "g", .doc = "standard deviation of normal noise", .at_least = 0.0});
  is.parameter<&LoadCell::range>({.unit = "V", .doc = "the gauges show -range to range", .above = 0.0});
  is.parameter<&LoadCell::seed>({.doc = "which sequence of noise; a whole number", .required = true});
  is.input<&LoadCell::force>({.unit = "N", .doc = "[x, y, z] in the axes of the cell"});
  is.input<&LoadCell::torque>({.unit = "N m", .doc = "[x, y, z] about its origin"});
  is.output<&LoadCell::gauges>({.unit = "V", .doc = "of the six pairs of gauges"});
  is.state<&LoadCell::sample>({.doc = "number of the sample", .settable = false});
  is.diagnostic<&LoadCell::overloaded>(
      {.doc = "the load is beyond the cell's range; its gauges show the end"});
  is.clock<&LoadCell::time>();
  is.preset<ati_mini40_si_80_4>("ati-mini40-si-80-4",
                                "80 N across, 240 N along, 4 N m; the arrangement of its gauges is assumed");
  is.preset<ati_mini40_si_40_2>("ati-mini40-si-40-2", "40 N across, 120 N along, 2 N m; else alike");
  is.derived<&LoadCell::response, &LoadCell::calibration>();
}

}  // namespace stepwire
