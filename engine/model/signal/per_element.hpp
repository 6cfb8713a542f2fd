#pragma once

#include <cmath>

#include "engine/model/signal/numbers.hpp"

#ifndef STEPWIRE_LANES  // there lane_numbers.hpp has another one

namespace stepwire {

/// A parameter with one number for each element of a signal. A file may give a single number for all of them,
/// which lies in the block itself: most blocks of a diagram have one element, and are walked by the thousand.
class PerElement {
 public:
  PerElement(double all) : one_(all) {}
#ifndef STEPWIRE_LONGEST_LIST
  explicit PerElement(const Numbers& elements) {
    one_ = elements.empty() ? 0.0 : elements[0];
    if (elements.size() != 1) many_ = new_elements(elements.data(), elements.size());
  }
#endif
  /// Elements behind their number with a minus, `{-3.0, 1.0, 2.0, 3.0}`, which outlive this object and
  /// whatever is copied from it.
  static PerElement view(const double* counted) {
    PerElement elements(counted[0] == 0.0 ? 0.0 : counted[1]);
    elements.many_ = counted + 1;
    return elements;
  }

  /// `of(k)` for each of `size` elements; a single one takes no memory. A generated program prepares a block
  /// for one element after the other, so there is one there.
  template <class Function>
  static PerElement made([[maybe_unused]] Index size, const Function& of) {
#ifndef STEPWIRE_LONGEST_LIST
    if (size != 1) return made_of_many(size, of);
#endif
    return PerElement(of(Index{0}));
  }

  PerElement(const PerElement& other) : one_(other.one_), many_(other.many_) {
    if constexpr (lists_take_memory)
      if (other.owns()) many_ = new_elements(other.many_, other.size());
  }
  PerElement(PerElement&& other) noexcept : one_(other.one_), many_(std::exchange(other.many_, nullptr)) {}
  PerElement& operator=(PerElement other) noexcept {
    std::swap(one_, other.one_);
    std::swap(many_, other.many_);
    return *this;
  }
  ~PerElement() { free(); }

  double operator[](Index i) const {
    if (__builtin_constant_p(i) && i == 0) return one_;  // the compiler sees that the signal has one element
    return many_ ? many_[i] : one_;
  }
  Index size() const { return many_ ? static_cast<Index>(many_[-1] < 0.0 ? -many_[-1] : many_[-1]) : 1; }
  const double* data() const { return many_ ? many_ : &one_; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  /// The same function of each number.
  template <class Function>
  PerElement map(const Function& of) const {
    return made(size(), [&](Index k) { return of(data()[k]); });
  }

 private:
  template <class Function>
  static PerElement made_of_many(Index size, const Function& of) {
    double* counted = new double[static_cast<std::size_t>(size) + 1];
    counted[0] = static_cast<double>(size);
    for (Index k = 0; k < size; ++k) counted[k + 1] = of(k);
    PerElement elements(size == 0 ? 0.0 : counted[1]);
    elements.many_ = counted + 1;
    return elements;
  }
  static const double* new_elements(const double* elements, Index size) {
    double* counted = new double[static_cast<std::size_t>(size) + 1];
    counted[0] = static_cast<double>(size);
    std::copy_n(elements, size, counted + 1);
    return counted + 1;
  }
  void free() {
    if constexpr (lists_take_memory)
      if (owns()) delete[](many_ - 1);
  }
  bool owns() const { return many_ && !std::signbit(many_[-1]); }  // -0.0: a view of none

  double one_;                    ///< the first number
  const double* many_ = nullptr;  ///< where there is not just one; the element before them is their number
};

}  // namespace stepwire

#endif
