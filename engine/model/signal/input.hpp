#pragma once

#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Input port: a view of the output of its source. An optional input without a source is not connected.
template <int size_at_build = any_size>
class Input {
 public:
  double operator[](Index i) const { return data_[i * lanes]; }
  Index size() const { return size_; }
#ifndef STEPWIRE_LANES
  const double* data() const { return data_; }  ///< see Signal::data()
#endif
  bool connected() const { return data_ != nullptr; }

  Input() = default;
  Input(const Input&) = default;
  Input& operator=(const Input&) = delete;
  void bind(const double* data, Index size) {
    data_ = data;
    size_ = size;
  }

 private:
  const double* data_ = nullptr;
  Index size_ = size_at_build == any_size ? 0 : size_at_build;
};

/// Scalar input; converts to a double.
template <>
class Input<1> {
 public:
  operator double() const { return *data_; }
  bool connected() const { return data_ != nullptr; }
  void bind(const double* data, Index) { data_ = data; }

 private:
  const double* data_ = nullptr;
};

/// A list of inputs of one kind, `u: [a, b, c]`. Each has the size of the block, or one element that is used
/// for all.
class Inputs {
 public:
  struct Element {
    Index size = 0;

    Element() = default;
    Element(const double* data, Index elements) : size(elements), data_(data) {}
    /// Returns element i; the only one of a scalar.
    double operator[](Index i) const {
      if (__builtin_constant_p(i) && i == 0) return *data_;
      return data_[size == 1 ? 0 : i * lanes];
    }

   private:
    friend class Inputs;
    const double* data_ = nullptr;  ///< numbers with a stride of `lanes`
  };

  Index count() const { return count_; }
  const Element& operator[](Index input) const { return elements_[input]; }
  /// Copies element k of each input.
  void gather(Index k, double* values) const {
    STEPWIRE_UNROLLED
    for (Index i = 0; i < count_; ++i) values[i] = elements_[i][k];
  }
  /// Returns the first element of an input; the whole input where the output is scalar.
  double first(Index input) const {
    return __builtin_constant_p(input) && input < 2 ? *few_[input] : *elements_[input].data_;
  }
  /// Binds the elements without copying. They are stored next to those of neighbouring blocks in the order of
  /// execution, for locality.
  void bind(const Element* elements, Index count) {
    elements_ = elements;
    count_ = count;
    for (Index i = 0; i < 2; ++i) few_[i] = i < count ? elements[i].data_ : nullptr;
  }

 private:
  const double* few_[2] = {};  ///< the first two elements, enough for most lists, inside of the block
  const Element* elements_ = nullptr;
  Index count_ = 0;
};

}  // namespace stepwire
