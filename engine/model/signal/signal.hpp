#pragma once

#include "engine/model/signal/lane.hpp"

namespace stepwire {

/// Signal that a block writes: a view of `size` numbers in the workspace. Assignment writes through.
template <int size_at_build = any_size>
class Signal {
 public:
  double& operator[](Index i) { return data_[i * lanes]; }
  double operator[](Index i) const { return data_[i * lanes]; }
  Index size() const { return size_; }
  /// Returns a pointer to its numbers for code with its own loops.
  Lane elements() const { return {data_}; }
#ifndef STEPWIRE_LANES
  /// Returns contiguous numbers. Blocks that use it are excluded from lane batches, where numbers are not
  /// contiguous.
  double* data() { return data_; }
  const double* data() const { return data_; }
#endif

  Signal() = default;
  Signal(const Signal&) = default;
  Signal& operator=(double value) {
    each([&](Index) { return value; });
    return *this;
  }
  /// Copies the numbers of another signal of this size.
  template <class Numbers>
  Signal& operator=(const Numbers& value) {
    each([&](Index i) { return value[i]; });
    return *this;
  }
  /// Sets each element to a function of its index. The common case of one element avoids the cost of a loop.
  template <class Function>
  void each(const Function& of) {
    if (size_ == 1) {
      data_[0] = of(Index{0});
    } else {
      each_of_many(of);
    }
  }
  Signal& operator=(const Signal& value) { return this->template operator=<Signal>(value); }

  void bind(double* data, Index size) {
    data_ = data;
    size_ = size;
  }

 private:
  template <class Function>
  STEPWIRE_RARE void each_of_many(const Function& of) {
    for (Index i = 0; i < size_; ++i) data_[i * lanes] = of(i);
  }

  double* data_ = nullptr;
  Index size_ = size_at_build == any_size ? 0 : size_at_build;
};

/// Scalar signal; reads and writes as a double.
template <>
class Signal<1> {
 public:
  operator double() const { return *data_; }
  Signal& operator=(double value) {
    *data_ = value;
    return *this;
  }
  Signal() = default;
  Signal(const Signal&) = default;
  Signal& operator=(const Signal& value) { return *this = static_cast<double>(value); }
  void bind(double* data, Index) { data_ = data; }

 private:
  double* data_ = nullptr;
};

/// An output port.
template <int size_at_build = any_size>
class Output : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
};

/// A continuous state: its value, and its time `derivative`, which derivatives() writes.
template <int size_at_build = any_size>
class State : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
  Signal<size_at_build> derivative;
};

/// A discrete state: memory of the block between ticks, changed only by update().
template <int size_at_build = any_size>
class DiscreteState : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
};

}  // namespace stepwire
