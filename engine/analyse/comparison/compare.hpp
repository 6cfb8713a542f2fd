#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/comparison/tolerance.hpp"
#include "engine/analyse/comparison/trace.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::comparison {

/// Values of B at the instants of A.
enum class Method {
  rows,    ///< B has a row at each of them.
  linear,  ///< Straight lines between the rows of B.
  hold     ///< The value of the last row of B.
};

/// Difference of one signal. Numbers are in `unit`, that of A.
struct SignalDifference {
  std::string name, unit;
  bool agrees = true;
  double difference = 0.0;        ///< Largest absolute difference; beyond the jitter where there is one.
  std::optional<double> share{};  ///< The same as a share of the largest absolute value of A.
  double time = 0.0;              ///< Its time [s].
  std::size_t run = 0;            ///< Its run, of several.
  double a = 0.0, b = 0.0;        ///< Both values there; with jitter the nearest of the other within it.
  double tolerance = 0.0;
  double excess = 0.0;        ///< Largest difference divided by the tolerance; above 1 it differs.
  std::size_t rows = 0;       ///< Compared rows of A.
  std::size_t differing = 0;  ///< Rows beyond the tolerance.
  std::size_t missing = 0;    ///< Rows where one side alone has no number.
  std::size_t unpaired = 0;   ///< Rows of A before an event of which B has a single side.
  Method method = Method::rows;
  std::vector<std::string> notes{};  ///< Other lengths, rows of B that are not compared.
};

/// Difference of two recordings, the worst signals first.
struct RecordingDifference {
  std::string a{}, b{};  ///< Names of the two recordings.
  bool agrees = true;
  std::vector<SignalDifference> signals{};
  std::vector<std::string> only_in_a{}, only_in_b{};
  std::vector<std::string>
      faults{};  ///< Reasons why a comparison is impossible: units, columns without times.
};

/// Tables of a recording.
using Tables = std::span<const table::Table* const>;

/// Compares the signals of two recordings at the instants of A. With jitter and at least as many rows in A as
/// in B, also at those of B. Without a tolerance the difference may be 1e-12 of the largest value, for the
/// rounding of units and of lines between rows.
RecordingDifference compare(Tables a, Tables b, const Tolerances& tolerances);

/// Both values of a signal and their difference at the instants of A, in the unit of A.
struct DifferenceCurves {
  std::vector<double> time, a, b, difference;
};
DifferenceCurves curves_of(Tables a, Tables b, const SignalDifference& signal, const Tolerances& tolerances);

/// Returns "rows", "linear" or "hold".
const char* method_name(Method method);

/// Returns one sentence about a signal: "force: differs by 0.3 N (1.5 %) at 0.2 s, tolerance 0.1 N".
std::string difference_text(const SignalDifference& signal);

/// Declares the fields of the result of `compare --json`.
void declare(result::Record<RecordingDifference>& is);

}  // namespace stepwire::comparison
