#pragma once

#include <cmath>

#include "engine/drivers/comedi/library.hpp"

namespace stepwire::comedi {

/// Lines of an encoder out of the numbers of its counter, over the wrap of that.
///
/// A counter with an index pulse begins in the middle of its range, and each pulse sets it to 0. So a number
/// near 0 means that the pulse was seen. From then on the lines count from the pulse, whole turns included:
/// of all counts that differ by turns the nearest to the last one is taken, which corrects lost edges.
class Encoder {
 public:
  /// `turn` is the number of counts between two pulses of the index, 0 without one.
  Encoder(Sample most, double multiplication, double turn)
      : most_(most), multiplication_(multiplication), turn_(turn) {}

  bool has_index() const { return turn_ > 0.0; }
  bool seen() const { return seen_; }
  /// Returns the number with which the counter begins.
  Sample beginning() const { return has_index() ? most_ / 2 + 1 : 0; }
  void begin(Sample number) {
    last_ = number;
    counts_ = 0.0;
    seen_ = false;
  }
  double lines(Sample number) {
    const double from_pulse = with_sign(number);
    if (has_index() && std::abs(from_pulse) <= most_ / 4) {
      counts_ = seen_ ? from_pulse + turn_ * std::round((counts_ - from_pulse) / turn_) : from_pulse;
      seen_ = true;
    } else {
      counts_ += with_sign((number - last_) & most_);
    }
    last_ = number;
    return counts_ / multiplication_;
  }

 private:
  /// Returns the shorter way from 0 around the wrap.
  double with_sign(Sample number) const {
    return number > most_ / 2 ? static_cast<double>(number) - static_cast<double>(most_) - 1.0
                              : static_cast<double>(number);
  }

  Sample most_, last_ = 0;
  double multiplication_, turn_, counts_ = 0.0;
  bool seen_ = false;
};

}  // namespace stepwire::comedi
