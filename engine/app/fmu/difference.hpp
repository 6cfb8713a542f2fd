#pragma once

// Part of the sources of every exported unit, so it includes only the standard library.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>

#include "engine/app/fmu/moving_diagram.hpp"

namespace stepwire::fmu {

/// Directional derivatives of a diagram by central differences.
/// Each known number with a nonzero seed is perturbed in a copy of the diagram, which is evaluated on both
/// sides. So the diagram itself keeps its bytes. Cost: two evaluations for each such number.
template <class Source>
class Difference {
  using Moving = MovingDiagram<Source>;

 public:
  Difference(const Moving& at, References unknowns, std::size_t numbers)
      : at_(at),
        unknowns_(unknowns),
        count_(numbers),
        trial_(new (std::nothrow) Moving(at)),
        high_(new (std::nothrow) double[numbers + 1]),
        low_(new (std::nothrow) double[numbers + 1]) {}

  /// Writes to `sum` the derivatives by all known numbers, weighted by their seeds. False if memory
  /// allocation failed.
  bool add_all(References knowns, const double* seed, double* sum) {
    if (!trial_ || !high_ || !low_) return false;
    std::fill_n(sum, count_, 0.0);
    for (std::size_t i = 0; i < knowns.count; ++i) {
      const UnitVariable& known = Source::variables[knowns.of[i]];
      for (int k = 0; k < known.size; ++k, ++seed)
        if (*seed != 0.0) add(known, k, *seed, sum);
    }
    return true;
  }

 private:
  void add(const UnitVariable& known, int k, double seed, double* sum) {
    // Relative step, the cube root of the machine epsilon, and the smallest magnitude that it refers to.
    constexpr double part = 6e-6, least = 1e-3;
    look(known, k, 0.0, nullptr);
    const double x = trial_->number(known, k);
    const double h = part * std::fmax(std::fabs(x), least), above = x + h, below = x - h;
    look(known, k, above, high_.get());
    look(known, k, below, low_.get());
    for (std::size_t j = 0; j < count_; ++j) sum[j] += seed * ((high_[j] - low_[j]) / (above - below));
  }

  /// Resets the copy and reads the unknowns after setting a known number. With `values` nullptr it only
  /// resets.
  void look(const UnitVariable& known, int k, double value, double* values) {
    std::memcpy(static_cast<void*>(trial_.get()), &at_, sizeof at_);
    if (!values) return;
    trial_->forget();
    trial_->number(known, k) = value;
    trial_->evaluate();
    trial_->read(unknowns_, values);
  }

  const Moving& at_;
  References unknowns_;
  std::size_t count_;
  std::unique_ptr<Moving> trial_;
  std::unique_ptr<double[]> high_, low_;
};

}  // namespace stepwire::fmu
