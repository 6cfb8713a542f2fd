#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/symbol_table.hpp"
#include "engine/analyse/statistics/paired_test.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::claim {

/// Function that reduces the selected rows of a column to one number.
enum class Reduction {
  final,
  max,
  min,
  mean,
  rms,
  spread,
  fraction,
  count,
  at,
  quantile,
  rising,
  fit,
  overshoot,
  rise_time,
  settling_time,
  peak_time,
  iae,
  steady_error,
  fraction_of_runs,
  quantile_of_runs,
  like
};

struct RunFormula;
struct Likeness;

/// True for a reduction over several runs, each of which contributes one number.
inline bool is_of_runs(Reduction reduction) {
  return reduction == Reduction::fraction_of_runs || reduction == Reduction::quantile_of_runs;
}

/// Condition on the reduced value. A percent sign on `within` makes the tolerance relative: |value - equals|
/// <= 1 % of |equals|. Any other `within` is absolute and in the unit of the value.
struct Comparison {
  enum class Kind { equals, at_most, at_least, between };
  Kind kind = Kind::equals;
  double low = 0.0;     ///< Target of equals, bound of at_most and at_least, lower end of between.
  double high = 0.0;    ///< Upper end of between.
  double within = 0.0;  ///< Absolute tolerance of equals.
  std::string unit{};   ///< Unit in which the value is shown, as the author wrote it; empty: SI.
  std::string text{};   ///< Text such as "<= 2 N".

  /// Returns the distance of a value to the bound: positive where the claim holds, negative where it fails,
  /// -inf for nan.
  double margin(double value) const;
};

/// A statement about a run, checked against the recordings.
struct Claim {
  enum class Kind {
    statement,  ///< claim of the source (paper, data sheet) about this diagram
    invariant   ///< condition on every run of the rig: limits, energy, safety
  };
  Kind kind = Kind::statement;
  std::string that;
  std::string check;  ///< Text of the condition: "max abs(limit) <= 0 A where rig.x > -4 mm".
  Reduction reduction = Reduction::final;
  std::vector<query::Formula> values;  ///< One formula; two for rising (value, over), fit (model, measured).
  std::optional<query::Formula> where;
  double time = 0.0;                           ///< Time of `at`, in s.
  double share = 0.5;                          ///< Share of `quantile`, 0 to 1.
  std::shared_ptr<const RunFormula> of_run{};  ///< Number per run, for reductions over several runs.
  std::shared_ptr<Likeness> like{};            ///< Baseline of the claim `like`; nullptr for any other.
  std::optional<double> confidence{};  ///< Confidence level at which the comparison must hold; std::nullopt:
                                       ///< the estimate alone decides.
  bool each_run = false;  ///< True: judged for each run of a sweep, and the worst run is shown. Always so for
                          ///< final and at.
  bool free_offset = false;  ///< True: fit adds the mean of measured - model to the model first.
  Comparison comparison;
  std::string disagrees;  ///< Reason why this statement of the source is known to fail; empty: it is expected
                          ///< to hold.
  std::size_t recording = 0;
  yaml::Place place;
};

/// Outcome of a claim.
struct Verdict {
  Claim::Kind kind = Claim::Kind::statement;
  std::string that;
  std::string check;
  double value = 0.0;  ///< Reduced value in SI; nan if undefined. For fit in percent, for like the largest
                       ///< difference divided by its tolerance.
  std::string shown;   ///< The value with its unit, for reports.
  bool holds = false;
  std::string disagrees;  ///< Reason given in the file; empty if it gives none.
  std::string note;  ///< Reason why the claim could not be judged: no row selected, nothing recorded, nan.
  std::optional<std::size_t> run{};  ///< Index of the run that gave the value, of several.
  std::string worst{};               ///< Parameters of that run: "kp=20".
  /// Confidence interval of a reduction over several runs.
  std::optional<statistics::ConfidenceInterval> interval{};
  double confidence = 0.0;

  /// True where the file expects a failure (`disagrees`), but the claim holds: the file is out of date.
  bool surprises() const { return holds && !disagrees.empty(); }
  /// True for a failure that the file does not expect.
  bool fails() const { return !holds && disagrees.empty(); }
  /// Returns "holds", "does not hold", "does not hold (known)" or "holds after all".
  std::string word() const;
};

/// Returns the schema of a claim: its keys and their forms.
const yaml::Key& claim_form();

/// Reads the value under the key `claims` or `invariants`: a list of claims. Adds all faults to `faults`.
std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::SymbolTable& names,
                               yaml::Faults& faults);

/// Reads the list under another key; messages use that key's name.
std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::NamesReading& read);

/// Returns the number that a claim judges, for each run: std::nullopt where `where` selects no row of the
/// run, nan where the number is undefined.
std::vector<std::optional<double>> values_of_runs(const Claim& claim,
                                                  std::span<const record::Recording> recordings);

/// Judges a claim on the recordings.
Verdict judge(const Claim& claim, std::span<const record::Recording> recordings);

/// Returns the keys of the reductions of a formula, in the order of `Reduction`.
const std::vector<std::string>& reduction_names();

/// Returns the dimension of the reduced value; std::nullopt if unknown.
std::optional<unit::Dimension> reduced_dimension(const Claim& claim);

/// Returns the dimension of a difference of two such values, e.g. of a tolerance. It differs for
/// temperatures: K, not degC.
std::optional<unit::Dimension> difference_dimension(const Claim& claim);

/// Returns the condition of a claim as text; `time` is the time of `at` as written.
std::string check_text(const Claim& claim, const std::string& time);

/// Returns a reduced value with its unit: that of the comparison, else the first fitting unit in the
/// statement. The text has four digits and is on the same side of the bound as the value. It has more digits
/// if the claim fails, or if no number of four digits is on that side. The value of an `equals` that holds is
/// rounded. A value below the rounding error of `magnitude` and below 1 % of the bound is shown as 0.
std::string value_text(const Claim& claim, double value, double magnitude = 0.0);

}  // namespace stepwire::claim
