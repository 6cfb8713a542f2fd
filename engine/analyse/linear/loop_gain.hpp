#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/analyse/linear/frequency_response.hpp"

namespace stepwire::linear {

/// A frequency at which the gain of a loop is 1.
struct Crossover {
  double frequency = 0.0;  ///< In rad/s.
  bool falls = false;      ///< True if the gain is above 1 below it.
};

/// A range of frequencies [rad/s].
struct FrequencyBand {
  double from = 0.0, to = 0.0;
};

/// The frequency response of a loop L on a grid that resolves every pole, zero and turn of a delay, and the
/// points where it meets 1, the negative real axis or -1. The grid is refined where the loop touches the unit
/// circle or the real axis between two rows.
class LoopGain {
 public:
  struct Row {
    double frequency = 0.0;
    Complex value;
  };

  /// L is `sign` times the system. The grid is denser near the closed-loop poles.
  LoopGain(const StateSpace& system, double sign, const std::vector<Mode>& closed = {});

  Complex at(double frequency) const { return sign_ * response_.at(frequency); }
  /// Returns the limit of L at frequency 0; infinite or NaN if there is none.
  double at_rest() const { return at_rest_; }
  const FrequencyResponse& response() const { return response_; }
  const std::vector<Row>& rows() const { return rows_; }

  /// Returns a band of at least 2 % in which |L| differs from 1 by rounding alone, the widest one.
  std::optional<FrequencyBand> band_of_one() const;
  /// Returns all frequencies at which |L| = 1, except in such a band.
  std::vector<Crossover> crossovers() const;
  /// Rows at which L is real and negative. Where a chain of delays turns without end, they are complete up to
  /// `last` [rad/s], but for `left_out` rows in intervals with too many.
  struct Negative {
    std::vector<Row> rows;
    std::size_t left_out = 0;
    double last = std::numeric_limits<double>::infinity();
  };
  /// Returns all rows at which L is real and negative. In a band where it is so throughout, the row with the
  /// gain nearest to 1.
  Negative negative() const;
  /// Returns the row of the grid with the least |1 + L|, refined between its neighbours.
  Row nearest_to_minus_one() const;

 private:
  template <class Size>
  void add_touches(Size size);
  std::vector<FrequencyBand> bands(bool (*belongs)(const Complex& value)) const;
  bool is_rounding(const Row& row) const;
  bool turns_unseen(std::size_t row) const;
  double angle_after(const Row& row, double frequency) const;
  double half_turns(std::size_t row) const;
  Row half_turn(std::size_t row, double index) const;
  void add_half_turns(Negative& found) const;

  FrequencyResponse response_;
  double sign_, at_rest_;
  std::vector<Row> rows_;
};

}  // namespace stepwire::linear
