#pragma once

#include <algorithm>
#include <cmath>

namespace stepwire {

/// Sum of squares of numbers whose squares may overflow or underflow a double.
///
/// The sum is accumulated at three scales, by powers of two, and the one whose squares are in range is used.
/// For ordinary numbers that is the plain sum with its bits. There are no branches, so that loops over lanes
/// vectorise. J. L. Blue, "A portable Fortran program to find the Euclidean norm of a vector", 1978.
class SumOfSquares {
 public:
  void add(double x) {
    middle_ += x * x;
    large_ += squared(lifted(x) * down);
    small_ += squared(x * up);
  }
  /// Adds weight (a^2 + b^2).
  void add(double a, double b, double weight) {
    middle_ += weight * (a * a + b * b);
    large_ += weight * (squared(lifted(a) * down) + squared(lifted(b) * down));
    small_ += weight * (squared(a * up) + squared(b * up));
  }

  /// Returns the power of two that numbers must be multiplied by before they are squared.
  double scale() const { return middle_ > largest ? down : middle_ < smallest ? up : 1.0; }
  /// Returns the sum of squares of the numbers multiplied by scale().
  double scaled() const { return middle_ > largest ? large_ : middle_ < smallest ? small_ : middle_; }
  /// Returns the square root of the sum over `count`.
  double root(double count = 1.0) const { return std::sqrt(scaled() / count) * back(); }

 private:
  static constexpr double up = 0x1p600, down = 0x1p-600;  // scaled squares of 2^-1074 to 2^1023 are in range
  static constexpr double smallest = 0x1p-900, largest = 0x1p1000;
  static constexpr double least_lifted = 0x1p100;

  static double squared(double x) { return x * x; }
  /// Returns a magnitude whose scaled square does not underflow, which costs a processor a hundred times the
  /// product. Beside a sum that counts at this scale the smallest one vanishes.
  static double lifted(double x) { return std::max(std::abs(x), least_lifted); }

  /// 1 / scale(), a power of two as well.
  double back() const { return middle_ > largest ? up : middle_ < smallest ? down : 1.0; }

  double middle_ = 0.0, large_ = 0.0, small_ = 0.0;
};

/// Euclidean norm of the `count` numbers at(0), at(1), ...
template <class Count, class At>
double length_of(Count count, const At& at) {
  SumOfSquares squares;
  for (Count i = 0; i < count; ++i) squares.add(at(i));
  return squares.root();
}

}  // namespace stepwire
