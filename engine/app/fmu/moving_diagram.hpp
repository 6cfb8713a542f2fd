#pragma once

// Part of the sources of every exported unit: the standard library alone is included.

#include <cstdint>

#include "engine/app/fmu/exported_unit.hpp"

namespace stepwire::fmu {

/// All of a unit that moves: plain memory, whose bytes are the unit's state. `Source` has Diagram, the
/// generated struct, and the table `variables`.
template <class Source>
struct MovingDiagram {
  using Diagram = typename Source::Diagram;

  explicit MovingDiagram(bool exchange) : exchange(exchange) {}

  Diagram diagram;
  typename Diagram::State before{};  ///< as it stood when its outputs were computed; not for model exchange
  double time = 0.0;                 ///< [s], for model exchange
  std::int64_t first_tick = 0;
  Phase phase = Phase::made;
  bool exchange;
  bool evaluated = false;
  bool begins = true;           ///< from its parameters, once it is evaluated
  bool inputs_written = false;  ///< else they follow from the parameters, too

  double now() const { return exchange ? time : diagram.time(); }

  /// Computes the outputs of now, if they are not.
  void evaluate() {
    if (evaluated) return;
    if (begins) begin();
    if constexpr (requires(Diagram & d) { d.evaluate_at(0.0); })
      if (exchange) diagram.evaluate_at(time);
    if (!exchange) {
      diagram.save(before);
      diagram.evaluate();
    }
    evaluated = true;
  }

  /// Computes them once more where they are looked at again: an input or a parameter was written. What the
  /// blocks have noted of the former ones is forgotten.
  void forget() {
    if (evaluated && !exchange) static_cast<void>(diagram.restore(before));
    evaluated = false;
  }

  void advance() {
    diagram.advance();
    evaluated = false;
  }

  /// A number of a variable that has a place; FMI has rows of a matrix behind each other.
  double& number(const UnitVariable& variable, int k) {
    double* first = variable.place(&diagram);
    const int columns = variable.size / variable.rows;
    return first[variable.rows == 1 ? k : k % columns * variable.rows + k / columns];
  }

  /// The numbers of variables after evaluate().
  void read(References references, double* values) {
    for (std::size_t i = 0; i < references.count; ++i) {
      const UnitVariable& variable = Source::variables[references.of[i]];
      for (int k = 0; k < variable.size; ++k)
        *values++ = variable.kind == Kind::time        ? now()
                    : variable.kind == Kind::indicator ? crossing(k)
                                                       : number(variable, k);
    }
  }

  void write(References references, const double* values) {
    forget();
    for (std::size_t i = 0; i < references.count; ++i) {
      const UnitVariable& variable = Source::variables[references.of[i]];
      inputs_written |= variable.kind == Kind::input;
      for (int k = 0; k < variable.size; ++k) number(variable, k) = *values++;
    }
  }

 private:
  double crossing(int k) {
    if constexpr (requires(Diagram & d) { d.crossings(nullptr); }) {
      double numbers[Diagram::crossing_count];
      diagram.crossings(numbers);
      return numbers[k];
    }
    return 0.0;
  }

  void begin() {
    if constexpr (requires(Diagram & d) { d.inputs; }) {
      const auto inputs = diagram.inputs;
      diagram.reset();
      if (inputs_written) diagram.inputs = inputs;
    } else {
      diagram.reset();
    }
    diagram.tick = first_tick;
    begins = false;
  }
};

}  // namespace stepwire::fmu
