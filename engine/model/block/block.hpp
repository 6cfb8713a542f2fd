#pragma once

// Base header of blocks. Only their .cpp files need the declaration and configuration, see declare.hpp.
#include "engine/model/signal/clock.hpp"
#include "engine/model/signal/diagnostic.hpp"
#include "engine/model/signal/input.hpp"
#include "engine/model/signal/numbers.hpp"
#include "engine/model/signal/per_element.hpp"
#include "engine/model/signal/signal.hpp"
#include "engine/model/signal/text.hpp"

namespace stepwire {

/// Output of a block's crossings(): values that cross zero where its behaviour changes, such as its input
/// less a threshold. Their number and order are those of the declaration.
class Crossings {
 public:
  explicit Crossings(double* numbers) : next_(numbers) {}
  void add(double number) { *next_++ = number; }
  /// Adds a signal that was declared by crossing_of().
  void add_connected(const Input<1>& signal) {
    if (signal.connected()) add(signal);
  }

 private:
  double* next_;
};

class Configure;
struct Outline;

template <class Block>
class Declare;

}  // namespace stepwire
