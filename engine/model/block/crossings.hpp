#pragma once

namespace stepwire {

/// Output of a block's crossings(): values that cross zero where its behaviour changes, such as its input
/// less a threshold. Their number and order are those of the declaration.
class Crossings {
 public:
  explicit Crossings(double* numbers) : next_(numbers) {}
  void add(double number) { *next_++ = number; }

 private:
  double* next_;
};

}  // namespace stepwire
