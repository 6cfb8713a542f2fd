#pragma once

#include <cmath>

#include "engine/model/signal/numbers.hpp"

#ifndef STEPWIRE_LANES  // lane_numbers.hpp has the variant for lanes

namespace stepwire {

/// A parameter with one number for each element of a signal, or a single number for all elements. The single
/// number is stored inside of the block: most blocks have one element, and diagrams have thousands of them.
class PerElement {
 public:
  PerElement(double all) : one_(all) {}
#ifndef STEPWIRE_LONGEST_LIST
  explicit PerElement(const Numbers& elements) {
    one_ = elements.empty() ? 0.0 : elements[0];
    if (elements.size() != 1) many_ = new_elements(elements.data(), elements.size());
  }
#endif
  /// Makes a view of elements after their negative count, `{-3.0, 1.0, 2.0, 3.0}`. They must outlive this
  /// object and all its copies.
  static PerElement view(const double* counted) {
    PerElement elements(counted[0] == 0.0 ? 0.0 : counted[1]);
    elements.many_ = counted + 1;
    return elements;
  }

  /// Makes `size` elements of(k); a single one needs no heap memory. A generated program prepares blocks
  /// element by element, so `size` is 1 there.
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
    if (__builtin_constant_p(i) && i == 0) return one_;  // a compile-time branch for scalar signals
    return many_ ? many_[i] : one_;
  }
  Index size() const { return many_ ? static_cast<Index>(many_[-1] < 0.0 ? -many_[-1] : many_[-1]) : 1; }
  const double* data() const { return many_ ? many_ : &one_; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  /// Returns `of` applied to each number.
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
  bool owns() const { return many_ && !std::signbit(many_[-1]); }  // -0.0: an empty view

  double one_;                    ///< the first number
  const double* many_ = nullptr;  ///< nullptr for a single number; preceded by the count, negative for a view
};

}  // namespace stepwire

#endif
