#pragma once

#include <cmath>

namespace stepwire {

/// The sum of the squares of numbers whose squares may be too large or too small for a double.
///
/// The sum is kept at three scales, by powers of two, and the one whose squares are in range counts: of
/// ordinary numbers it is the plain sum with its bits. There are no branches, so that loops over lanes go
/// into registers. J. L. Blue, "A portable Fortran program to find the Euclidean norm of a vector", 1978.
class SumOfSquares {
 public:
  void add(double x) {
    middle_ += x * x;
    large_ += x * down * (x * down);
    small_ += x * up * (x * up);
  }
  /// Adds weight (a^2 + b^2).
  void add(double a, double b, double weight) {
    middle_ += weight * (a * a + b * b);
    large_ += weight * (a * down * (a * down) + b * down * (b * down));
    small_ += weight * (a * up * (a * up) + b * up * (b * up));
  }

  /// The power of two by which numbers are to be multiplied before they are squared.
  double scale() const { return middle_ > largest ? down : middle_ < smallest ? up : 1.0; }
  /// The sum of the squares of numbers that are multiplied by scale().
  double scaled() const { return middle_ > largest ? large_ : middle_ < smallest ? small_ : middle_; }
  /// The root of the sum, divided by `count` before.
  double root(double count = 1.0) const { return std::sqrt(scaled() / count) * back(); }

 private:
  static constexpr double up = 0x1p600, down = 0x1p-600;  // 2^-1074 to 2^1023 have squares within range so
  static constexpr double smallest = 0x1p-900, largest = 0x1p1000;

  /// 1 / scale(), a power of two as well.
  double back() const { return middle_ > largest ? up : middle_ < smallest ? down : 1.0; }

  double middle_ = 0.0, large_ = 0.0, small_ = 0.0;
};

/// The length of a vector of `count` numbers `at(0)`, `at(1)`, ...
template <class Count, class At>
double length_of(Count count, const At& at) {
  SumOfSquares squares;
  for (Count i = 0; i < count; ++i) squares.add(at(i));
  return squares.root();
}

}  // namespace stepwire
