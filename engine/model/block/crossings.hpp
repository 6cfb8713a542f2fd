#pragma once

namespace stepwire {

/// What crossings() of a block writes: numbers that pass through zero where the block begins to do something
/// else, such as its input less a threshold; as many, and in this order, as its declaration has rows.
class Crossings {
 public:
  explicit Crossings(double* numbers) : next_(numbers) {}
  void add(double number) { *next_++ = number; }

 private:
  double* next_;
};

}  // namespace stepwire
