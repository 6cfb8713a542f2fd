#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace stepwire {

/// W1 written by hand: the same mathematics, without recording and checks.
template <int level = 2>
class HandWrittenW1 {
 public:
  void step();
  /// Returns x, v [mm, mm/s], z, i [A].
  const std::array<double, 4>& state() const { return state_; }

 private:
  std::array<double, 4> slope(double time, const std::array<double, 4>& s) const;
  double force(const std::array<double, 4>& s) const;
  void control(double time);

  std::array<double, 4> state_{};
  double held_current_ = 0.0, integral_ = 0.0, last_error_ = 0.0;
  long tick_ = 0;
};

/// W2 written by hand.
template <int level = 2>
class HandWrittenW2 {
 public:
  explicit HandWrittenW2(int blocks);
  void step();
  double sum() const;

 private:
  void slope(double time, const std::vector<double>& x, std::vector<double>& dot) const;

  std::vector<double> x_, stage_, k1_, k2_, k3_, k4_, gain_, pass_;
  long tick_ = 0;
};

}  // namespace stepwire
