#pragma once

#include <Eigen/Core>
#include <new>

namespace stepwire {

/// A port or state whose size is known only when the diagram is planned.
inline constexpr int any_size = Eigen::Dynamic;

/// What a block writes: a view of `size` numbers in the workspace. Assigning writes through.
template <int size_at_build = any_size>
class Signal : public Eigen::Map<Eigen::Array<double, size_at_build, 1>> {
 public:
  using Base = Eigen::Map<Eigen::Array<double, size_at_build, 1>>;
  Signal() : Base(nullptr, size_at_build == any_size ? 0 : size_at_build) {}
  Signal(const Signal&) = default;

  /// One element is the common case by far, and a loop set up for it would cost more than its work.
  template <class Expression>
  Signal& operator=(const Eigen::DenseBase<Expression>& value) {
    if (this->size() == 1) {
      this->coeffRef(0) = value.derived().coeff(0);
    } else {
      Base::operator=(value.derived());
    }
    return *this;
  }
  Signal& operator=(const Signal& value) { return *this = static_cast<const Base&>(value); }
  Signal& operator=(double value) {
    if (this->size() == 1) {
      this->coeffRef(0) = value;
    } else {
      this->setConstant(value);
    }
    return *this;
  }

  void bind(double* data, Eigen::Index size) { ::new (static_cast<Base*>(this)) Base(data, size); }
};

/// One number; reads and writes as a double.
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
  void bind(double* data, Eigen::Index) { data_ = data; }

 private:
  double* data_ = nullptr;
};

/// An output port.
template <int size_at_build = any_size>
class Output : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
};

/// A continuous state: its value, and `dot`, its time derivative, which derivatives() writes.
template <int size_at_build = any_size>
class State : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
  Signal<size_at_build> dot;
};

/// A state that only update() changes: the block's memory between its ticks.
template <int size_at_build = any_size>
class DiscreteState : public Signal<size_at_build> {
 public:
  using Signal<size_at_build>::operator=;
};

}  // namespace stepwire
