#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"
#include "engine/model/signal/index.hpp"
#include "tests/random/dice.hpp"
#include "tests/random/sketch.hpp"

namespace stepwire::random {

/// Rows and columns of a signal; a vector has one column.
struct Shape {
  Index rows = 1, columns = 1;

  Index size() const { return rows * columns; }
  bool operator==(const Shape&) const = default;
};

/// An output of a block as later blocks may read it.
struct Wire {
  std::string text;  ///< "n3", "n3.position", "n3.2"
  Shape shape;
  unit::Dimension unit;
};

/// An input whose source comes later in the file: the key is found by its text.
struct Promise {
  std::string text;
  Shape shape;
  std::optional<unit::Dimension> unit;  ///< nullopt: any
  bool gentle = false;                  ///< in an algebraic loop, whose gain has to stay below 1
};

/// A diagram while it is made: what it has, and what its next blocks may read.
class Bench {
 public:
  explicit Bench(std::uint64_t seed) : dice(seed) {}

  Dice dice;
  Sketch sketch;
  std::vector<Wire> wires;
  std::vector<Promise> promises;
  std::vector<std::string> states;  ///< of blocks, by the names under which they are recorded
  double step = 1e-3;               ///< [s]
  int ticks = 100;
  bool locates = false, solves_loops = false, guards = false, smooth = false, continuous = false;

  std::string next_name();
  void add(Entry entry) { sketch.blocks.push_back(std::move(entry)); }

  /// A signal of this shape: an element of a vector does for a number. Makes a source where there is none.
  Wire wire(const Shape& shape);
  /// Any signal that may be a matrix or not.
  Wire any_wire(bool may_be_matrix);
  /// The same signal, behind a Gain where it has another unit.
  Wire in_unit(const Wire& wire, const unit::Dimension& unit);
  /// Numbers in this unit, as text: an input or a parameter takes it.
  std::string literal(const Shape& shape, const unit::Dimension& unit);
  /// A number with its unit: as text, or as a new parameter of the file.
  std::string number(double value, const unit::Dimension& unit);
  /// Like number(), but never a parameter.
  static std::string plain(double value, const unit::Dimension& unit);

  /// A unit that signals may have; none more often than not.
  unit::Dimension some_unit();
  /// A time of some steps, at most a quarter of the run [s].
  double some_time();
  /// A period of some whole steps [s].
  double some_period() { return step * static_cast<double>(dice.of(std::vector<int>{1, 2, 3, 5, 10})); }
  /// A number of usual size: 0.1 to 2.
  double size() { return 0.1 * portable_exp(3.0 * dice.between(0.0, 1.0)); }
  double signed_size() { return dice.chance(0.5) ? size() : -size(); }

 private:
  Wire source(const Shape& shape);

  int count_ = 0;
};

/// Four digits of a number, as a file has them.
std::string digits(double value);
/// "[1, 2]", or "[[1, 2], [3, 4]]" row by row, or a number alone.
std::string list_text(const Shape& shape, const std::vector<double>& numbers);

}  // namespace stepwire::random
