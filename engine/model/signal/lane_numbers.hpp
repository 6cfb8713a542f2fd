#pragma once

#include <initializer_list>
#include <vector>

#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Construction of numbers inside a step, which lane code must not do. The function is never defined, so code
/// that calls it fails to load, and its runs are executed one by one.
template <class Made>
Made made_in_a_step();

/// Numbers in generated code for lane batches, always a view. Each loop over the runs constructs its block
/// anew, and the compiler must be able to optimise through it.
class NumbersInLanes {
 public:
  NumbersInLanes() = default;
  /// Default of a member, which the program always overwrites.
  NumbersInLanes(std::initializer_list<double>) {}
  NumbersInLanes(Index size, double value) : one_(value), size_(size) {}
  explicit NumbersInLanes(const std::vector<double>&) : NumbersInLanes(made_in_a_step<NumbersInLanes>()) {}
  NumbersInLanes(const double*, Index) : NumbersInLanes(made_in_a_step<NumbersInLanes>()) {}
  static NumbersInLanes view(const double* values, Index size) {
    NumbersInLanes numbers;
    numbers.data_ = values;
    numbers.size_ = size;
    return numbers;
  }

  double operator[](Index i) const { return data_ ? data_[i] : one_; }
  Index size() const { return size_; }
  template <class Function>
  NumbersInLanes map(const Function&) const {
    return made_in_a_step<NumbersInLanes>();
  }
  bool empty() const { return size_ == 0; }
  const double* data() const { return data_ ? data_ : &one_; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size_; }

 private:
  double one_ = 0.0;  ///< value of a list with one element
  const double* data_ = nullptr;
  Index size_ = 0;
};

using Numbers = NumbersInLanes;

/// The variant for a parameter with one number for each element of a signal.
class PerElementInLanes {
 public:
  PerElementInLanes(double all) : one_(all) {}
  explicit PerElementInLanes(const NumbersInLanes&)
      : PerElementInLanes(made_in_a_step<PerElementInLanes>()) {}
  static PerElementInLanes view(const double* counted) {
    PerElementInLanes elements(counted[0] == 0.0 ? 0.0 : counted[1]);
    elements.many_ = counted + 1;
    return elements;
  }
  template <class Function>
  static PerElementInLanes made(Index, const Function&) {
    return made_in_a_step<PerElementInLanes>();
  }

  double operator[](Index i) const {
    if (__builtin_constant_p(i) && i == 0) return one_;
    return many_ ? many_[i] : one_;
  }
  Index size() const { return many_ ? static_cast<Index>(many_[-1] < 0.0 ? -many_[-1] : many_[-1]) : 1; }
  const double* data() const { return many_ ? many_ : &one_; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  template <class Function>
  PerElementInLanes map(const Function&) const {
    return made_in_a_step<PerElementInLanes>();
  }

 private:
  double one_;
  const double* many_ = nullptr;
};

using PerElement = PerElementInLanes;

}  // namespace stepwire
