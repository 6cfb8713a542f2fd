#pragma once

#include "engine/model/signal/index.hpp"

namespace stepwire {

/// An input port: a view of what its source writes. An optional input that nothing feeds is not connected.
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

/// One number; reads as a double.
template <>
class Input<1> {
 public:
  operator double() const { return *data_; }
  bool connected() const { return data_ != nullptr; }
  void bind(const double* data, Index) { data_ = data; }

 private:
  const double* data_ = nullptr;
};

/// A list of inputs of one kind, `u: [a, b, c]`. Each has the block's size, or one element that stands for
/// all.
class Inputs {
 public:
  struct Element {
    Index size = 0;

    Element() = default;
    Element(const double* data, Index elements) : size(elements), data_(data) {}
    /// Element i of the signal; the only one where it has but one.
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
  /// First element of an input: all there is of it where the output has one element.
  double first(Index input) const {
    return __builtin_constant_p(input) && input < 2 ? *few_[input] : *elements_[input].data_;
  }
  /// The elements stay where they are: beside those of the blocks that run before and after, which is fast to
  /// walk.
  void bind(const Element* elements, Index count) {
    elements_ = elements;
    count_ = count;
    for (Index i = 0; i < 2; ++i) few_[i] = i < count ? elements[i].data_ : nullptr;
  }

 private:
  const double* few_[2] = {};  ///< the first two, which are all that most lists have, lie in the block itself
  const Element* elements_ = nullptr;
  Index count_ = 0;
};

}  // namespace stepwire
