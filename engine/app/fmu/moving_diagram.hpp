#pragma once

// Part of the sources of every exported unit, so it includes only the standard library.

#include <cstdint>

#include "engine/app/fmu/exported_unit.hpp"

namespace stepwire::fmu {

/// Complete mutable state of a unit, as plain memory whose bytes are the FMU state. `Source` has Diagram, the
/// generated struct, and the table `variables`.
template <class Source>
struct MovingDiagram {
  using Diagram = typename Source::Diagram;

  explicit MovingDiagram(bool exchange) : exchange(exchange) {}

  Diagram diagram;
  typename Diagram::State before{};  ///< state before the last evaluation; co-simulation only
  double time = 0.0;                 ///< time of model exchange [s]
  std::int64_t first_tick = 0;
  Phase phase = Phase::made;
  bool exchange;
  bool evaluated = false;
  bool begins = true;           ///< true if evaluate() must first reset the diagram to its parameters
  bool inputs_written = false;  ///< false: the inputs follow from the parameters

  double now() const { return exchange ? time : diagram.time(); }

  /// Computes the outputs of the present instant unless they are up to date.
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

  /// Invalidates the outputs after an input or a parameter was written. Restores the state before the
  /// evaluation, so that memory which blocks updated in it is not used twice.
  void forget() {
    if (evaluated && !exchange) static_cast<void>(diagram.restore(before));
    evaluated = false;
  }

  void advance() {
    diagram.advance();
    evaluated = false;
  }

  /// Returns the k-th number of a variable. FMI counts a matrix by rows, the diagram stores it by columns.
  double& number(const UnitVariable& variable, int k) {
    double* first = variable.place(&diagram);
    const int columns = variable.size / variable.rows;
    return first[variable.rows == 1 ? k : k % columns * variable.rows + k / columns];
  }

  /// Reads the numbers of variables; evaluate() must precede.
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
