#pragma once

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "engine/model/signal/index.hpp"

namespace stepwire {

#ifdef STEPWIRE_LANES
}  // namespace stepwire

#include "engine/model/signal/lane_numbers.hpp"

namespace stepwire {
#else

/// Constant numbers of a block during a run: a list parameter or values derived from parameters. They are
/// owned or a view of numbers elsewhere.
class Numbers {
 public:
  Numbers() = default;
  Numbers(std::initializer_list<double> values)
      : Numbers(values.begin(), static_cast<Index>(values.size())) {}
  explicit Numbers(const std::vector<double>& values)
      : Numbers(values.data(), static_cast<Index>(values.size())) {}
  Numbers(const double* values, Index size) { std::copy_n(values, size, make(size)); }
  /// Makes `size` copies of one number.
  Numbers(Index size, double value) { std::fill_n(make(size), size, value); }
  /// Makes a view. The numbers must outlive this object and all its copies.
  static Numbers view(const double* values, Index size) {
    Numbers numbers;
    numbers.data_ = values;
    numbers.size_ = size;
    return numbers;
  }

  Numbers(const Numbers& other) { take_copy(other); }
  Numbers(Numbers&& other) noexcept { take(other); }
  Numbers& operator=(const Numbers& other) {
    if (this != &other) *this = Numbers(other);
    return *this;
  }
  Numbers& operator=(Numbers&& other) noexcept {
    if (this == &other) return *this;
    free();
    take(other);
    return *this;
  }
  ~Numbers() { free(); }

  double operator[](Index i) const { return data_[i]; }
  Index size() const { return size_; }
  /// Returns `of` applied to each number.
  template <class Function>
  Numbers map(const Function& of) const {
    Numbers result;
    std::transform(begin(), end(), result.make(size_), of);
    return result;
  }
  bool empty() const { return size_ == 0; }
  const double* data() const { return data_; }
  const double* begin() const { return data_; }
  const double* end() const { return data_ + size_; }

  static constexpr Index capacity = numbers_in_list;  ///< longest list without heap memory

 private:
  double* make(Index size) {
    size_ = size;
    double* place = few_;
    if constexpr (lists_take_memory)
      if (size > capacity) place = many_ = new double[static_cast<std::size_t>(size)];
    data_ = place;
    return place;
  }
  void free() {
    if constexpr (lists_take_memory) delete[] many_;
  }
  void take_copy(const Numbers& other) {
    if (other.owns()) {
      std::copy_n(other.data_, other.size_, make(other.size_));
    } else {
      data_ = other.data_;
      size_ = other.size_;
    }
  }
  void take(Numbers& other) {
    many_ = std::exchange(other.many_, nullptr);
    std::copy_n(other.few_, capacity, few_);
    size_ = other.size_;
    data_ = other.data_ == other.few_ ? few_ : other.data_;
  }
  bool owns() const { return many_ || data_ == few_; }

  double few_[capacity] = {};  ///< short lists are inside of the block, which saves a memory access
  const double* data_ = few_;
  Index size_ = 0;
  double* many_ = nullptr;
};

#endif

/// A constant matrix of a block, in column-major order.
class Matrix {
 public:
  Matrix() = default;
  Matrix(Index rows, Index columns, Numbers elements)
      : rows_(rows), columns_(columns), elements_(std::move(elements)) {}

  double operator()(Index row, Index column) const { return elements_[column * rows_ + row]; }
  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  const Numbers& elements() const { return elements_; }

 private:
  Index rows_ = 0, columns_ = 0;
  Numbers elements_;
};

/// Default of a limit that a file may omit.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace stepwire
