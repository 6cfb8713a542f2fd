#include "blocks/hardware/gauge_calibration.hpp"

#include <Eigen/LU>
#include <numbers>

#include "engine/base/math/elementary.hpp"

namespace stepwire {

namespace {

using Square = Eigen::Matrix<double, 6, 6>;

Matrix matrix_of(const Square& square) {
  return {6, 6, Numbers(square.data(), 36)};
}

Square square_of(const Matrix& matrix) {
  return Eigen::Map<const Square>(matrix.elements().data());
}

}  // namespace

Matrix three_beams(double across, double along, double torque) {
  constexpr double shown = 4.0;
  Square calibration = Square::Zero();
  for (int beam = 0; beam < 3; ++beam) {
    const double at = 2.0 * std::numbers::pi * beam / 3.0, sine = fn::sin(at), cosine = fn::cos(at);
    calibration(2, beam) = along / 3.0;
    calibration(3, beam) = torque * sine * 2.0 / 3.0;
    calibration(4, beam) = -torque * cosine * 2.0 / 3.0;
    calibration(0, beam + 3) = -across * sine * 2.0 / 3.0;
    calibration(1, beam + 3) = across * cosine * 2.0 / 3.0;
    calibration(5, beam + 3) = torque / 3.0;
  }
  return matrix_of(calibration / shown);
}

Matrix inverse_of(const Matrix& calibration) {
  return matrix_of(square_of(calibration).inverse());
}

const char* calibration_problem(const Matrix& calibration) {
  if (calibration.rows() != 6 || calibration.columns() != 6)
    return "must have six rows, [Fx, Fy, Fz, Tx, Ty, Tz], of six numbers, one for each gauge";
  if (!square_of(calibration).fullPivLu().isInvertible())
    return "has no inverse: different loads would show the same voltages";
  return nullptr;
}

}  // namespace stepwire
