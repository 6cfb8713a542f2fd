#pragma once

#include <Eigen/Core>
#include <new>

#include "engine/signal/signal.hpp"

namespace stepwire {

/// An input port: a view of what its source writes. An optional input that nothing feeds is not connected.
template <int size_at_build = any_size>
class Input : public Eigen::Map<const Eigen::Array<double, size_at_build, 1>> {
 public:
  using Base = Eigen::Map<const Eigen::Array<double, size_at_build, 1>>;
  Input() : Base(nullptr, size_at_build == any_size ? 0 : size_at_build) {}
  Input(const Input&) = default;
  Input& operator=(const Input&) = delete;

  bool connected() const { return this->data() != nullptr; }
  void bind(const double* data, Eigen::Index size) { ::new (static_cast<Base*>(this)) Base(data, size); }
};

/// One number; reads as a double.
template <>
class Input<1> {
 public:
  operator double() const { return *data_; }
  bool connected() const { return data_ != nullptr; }
  void bind(const double* data, Eigen::Index) { data_ = data; }

 private:
  const double* data_ = nullptr;
};

/// A list of inputs of one kind, `u: [a, b, c]`. Each has the block's size, or one element that stands for
/// all.
class Inputs {
 public:
  struct Element {
    const double* data;
    Eigen::Index size;
    /// Element i of the signal; the only one where it has but one.
    double operator[](Eigen::Index i) const { return data[size == 1 ? 0 : i]; }
  };

  Eigen::Index count() const { return count_; }
  const Element& operator[](Eigen::Index input) const { return elements_[input]; }
  Eigen::Map<const Eigen::ArrayXd> view(Eigen::Index input) const {
    return {elements_[input].data, elements_[input].size};
  }
  /// The elements stay where they are: beside those of the blocks that run before and after, which is fast to
  /// walk.
  void bind(const Element* elements, Eigen::Index count) {
    elements_ = elements;
    count_ = count;
  }

 private:
  const Element* elements_ = nullptr;
  Eigen::Index count_ = 0;
};

}  // namespace stepwire
