#pragma once

#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Returns the calibration of a load cell on three beams at 0, 120 and 240 degrees. Each beam has a pair of
/// gauges: one for bending along z (gauges 1 to 3) and one across (4 to 6). At a load of `across` [N] along x
/// or y, of `along` [N] along z or of `torque` [N m] the gauges show at most 4 V. All loads together
/// therefore stay below 10 V. The certificate of a real cell has 36 numbers of its own.
Matrix three_beams(double across, double along, double torque);

/// Returns the voltages of a unit load along each axis, for a calibration without a problem.
Matrix inverse_of(const Matrix& calibration);

/// Returns the fault of a calibration that is not six by six or has no inverse; nullptr without a fault.
const char* calibration_problem(const Matrix& calibration);

}  // namespace stepwire
