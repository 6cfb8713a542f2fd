#pragma once

#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Calibration of a load cell that carries its load on three beams at 0, 120 and 240 degrees, each with a
/// pair of gauges for what bends it along z (gauges 1 to 3) and one across (4 to 6). At a load of `across`
/// [N] along x or y, of `along` [N] along z or of `torque` [N m] the gauges concerned show 4 V at most, so
/// that all at once stay below 10 V. The certificate of a real cell has 36 numbers of its own.
Matrix three_beams(double across, double along, double torque);

/// The voltages of a unit load along each axis, of a calibration without a problem.
Matrix inverse_of(const Matrix& calibration);

/// What is wrong with a calibration: not six by six, or without an inverse; null where nothing is.
const char* calibration_problem(const Matrix& calibration);

}  // namespace stepwire
