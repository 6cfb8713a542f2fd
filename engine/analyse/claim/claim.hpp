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

/// How a claim makes one number of a column.
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
  quantile_of_runs
};

struct RunFormula;

/// Is it a number of several runs, made of one of each?
inline bool is_of_runs(Reduction reduction) {
  return reduction == Reduction::fraction_of_runs || reduction == Reduction::quantile_of_runs;
}

/// What the reduced value is held against. A percent sign on `within` makes it relative: |value - equals| <=
/// 1 % of |equals|; any other `within` is absolute and in the unit of the value.
struct Comparison {
  enum class Kind { equals, at_most, at_least, between };
  Kind kind = Kind::equals;
  double low = 0.0;     ///< the wanted value, or the lower end of between
  double high = 0.0;    ///< upper end of between
  double within = 0.0;  ///< absolute tolerance of equals
  std::string unit{};   ///< in which the author wrote it, for showing the value; empty: SI
  std::string text{};   ///< "<= 2 N"

  /// How far the value is on the right side: negative where the claim fails; nan never holds and gives -inf.
  double margin(double value) const;
};

/// A statement about a run that is checked on what it recorded.
struct Claim {
  enum class Kind {
    statement,  ///< what the source says of this diagram
    invariant   ///< what must hold throughout any run of the rig: limits, energy, safety
  };
  Kind kind = Kind::statement;
  std::string that;
  std::string check;  ///< the condition as text: "max abs(limit) <= 0 A where rig.x > -4 mm"
  Reduction reduction = Reduction::final;
  std::vector<query::Formula> values;  ///< one; two for rising (value, over) and fit (model, measured)
  std::optional<query::Formula> where;
  double time = 0.0;                           ///< for at, in s
  double share = 0.5;                          ///< for quantile, 0 to 1
  std::shared_ptr<const RunFormula> of_run{};  ///< what is one number of a run, for those of several runs
  std::optional<double> confidence{};  ///< with which they satisfy the comparison; none: the estimate does
  bool each_run = false;  ///< judged for every run of a sweep, the worst is shown; always so for final and at
  bool free_offset = false;  ///< fit: the mean of measured - model is added to the model first
  Comparison comparison;
  std::string
      disagrees;  ///< why this statement of the source is known not to hold; empty: it is expected to hold
  std::size_t recording = 0;
  yaml::Place place;
};

/// What became of a claim.
struct Verdict {
  Claim::Kind kind = Claim::Kind::statement;
  std::string that;
  std::string check;
  double value = 0.0;  ///< reduced, in SI (percent for fit); nan where there is none
  std::string shown;   ///< the value with its unit, for people
  bool holds = false;
  std::string disagrees;             ///< the reason given in the file, if any
  std::string note;                  ///< why it could not be judged: no row selected, nothing recorded, nan
  std::optional<std::size_t> run{};  ///< which of several runs the value is of
  std::string worst{};               ///< what that run sets: "kp=20"
  /// Of a number of several runs: between which numbers it lies with this confidence.
  std::optional<statistics::ConfidenceInterval> interval{};
  double confidence = 0.0;

  /// A claim that is said to disagree but holds after all: the file is wrong about it.
  bool surprises() const { return holds && !disagrees.empty(); }
  /// It fails and nobody said that it would.
  bool fails() const { return !holds && disagrees.empty(); }
  /// "holds", "does not hold", "does not hold (known)", "holds after all".
  std::string word() const;
};

/// The keys of a claim.
const yaml::Key& claim_form();

/// Reads the value under the key `claims` or `invariants`: a list of claims. Everything that is wrong goes to
/// `faults`.
std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::SymbolTable& names,
                               yaml::Faults& faults);

/// The same under another key, by which messages call it.
std::vector<Claim> read_claims(const yaml::Node& node, Claim::Kind kind, const query::NamesReading& read);

/// The number that a claim judges, of each run by itself; none of a run of which `where` selects no row. Nan
/// where there is no such number.
std::vector<std::optional<double>> values_of_runs(const Claim& claim,
                                                  std::span<const record::Recording> recordings);

/// Judges a claim on what was recorded.
Verdict judge(const Claim& claim, std::span<const record::Recording> recordings);

}  // namespace stepwire::claim
