#pragma once

#include <Eigen/Core>
#include <new>
#include <vector>

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

/// A list of inputs of one kind, `u: [a, b, c]`. Each has the block's size, or one element that stands for all.
class Inputs {
 public:
  struct Element {
    const double* data;
    Eigen::Index stride;  ///< 0 for one element that stands for all
    double operator[](Eigen::Index i) const { return data[i * stride]; }
  };

  Eigen::Index count() const { return static_cast<Eigen::Index>(elements_.size()); }
  const Element& operator[](Eigen::Index input) const { return elements_[static_cast<std::size_t>(input)]; }
  Eigen::Map<const Eigen::ArrayXd> view(Eigen::Index input) const {
    return {(*this)[input].data, sizes_[static_cast<std::size_t>(input)]};
  }

  void add(const double* data, Eigen::Index size) {
    elements_.push_back({data, size == 1 ? 0 : 1});
    sizes_.push_back(size);
  }
  void clear() {
    elements_.clear();
    sizes_.clear();
  }

 private:
  std::vector<Element> elements_;
  std::vector<Eigen::Index> sizes_;
};

}  // namespace stepwire
