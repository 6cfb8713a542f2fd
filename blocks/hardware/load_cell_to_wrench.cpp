#include "blocks/hardware/load_cell_to_wrench.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void LoadCellToWrench::configure(Configure& is) {
  if (const char* problem = calibration_problem(calibration))
    is.refuse<&LoadCellToWrench::calibration>(problem);
  is.size("g", 6);
}

void LoadCellToWrench::declare(Declare<LoadCellToWrench>& is) {
  is.block("LoadCellToWrench",
           {.doc = "Force and torque from the voltages of a six-axis load cell, by its calibration. While "
                   "`tare` is true the cell carries no load but its own: the mean of the voltages over that "
                   "time counts as 0 from then on, until the next tare.",
            .source = "thesis 3.2; datasheet of the ATI Mini40",
            .timing = Timing::discrete});
  is.parameter<&LoadCellToWrench::calibration>(
      {.shape = "6 x 6", .doc = "rows [Fx, Fy, Fz, Tx, Ty, Tz] in N and N m, for a volt of each gauge"});
  is.parameter<&LoadCellToWrench::offset>(
      {.unit = "V", .shape = "g", .doc = "what the gauges show without a load, before the first tare"});
  is.parameter<&LoadCellToWrench::range>(
      {.unit = "V", .doc = "a gauge that shows this much is saturated", .above = 0.0});
  is.input<&LoadCellToWrench::gauges>({.unit = "V", .doc = "voltages of the six pairs of gauges"});
  is.input<&LoadCellToWrench::tare>({.unit = "*", .doc = "true while there is no load", .optional = true});
  is.output<&LoadCellToWrench::force>({.unit = "N", .doc = "[x, y, z] in the axes of the cell"});
  is.output<&LoadCellToWrench::torque>({.unit = "N m", .doc = "[x, y, z] about its origin"});
  is.output<&LoadCellToWrench::saturated>(
      {.doc = "1 while a gauge is at its end, so that the load may be larger"});
  is.state<&LoadCellToWrench::sum>(
      {.unit = "V", .doc = "of the voltages of the last tare", .settable = false});
  is.state<&LoadCellToWrench::count>({.doc = "how many they were", .settable = false});
  is.state<&LoadCellToWrench::taring>({.doc = "1 where the last tick belonged to a tare", .settable = false});
  is.preset<ati_mini40_si_80_4>("ati-mini40-si-80-4", "80 N across, 240 N along, 4 N m");
  is.preset<ati_mini40_si_40_2>("ati-mini40-si-40-2", "40 N across, 120 N along, 2 N m");
}

}  // namespace stepwire
