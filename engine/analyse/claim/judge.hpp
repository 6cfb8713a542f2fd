#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/likeness.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// Judges a claim on runs that arrive in pieces. It keeps their rows only for reductions that need all of
/// them.
class Judge {
 public:
  /// The claim must outlive the judge.
  explicit Judge(const Claim& claim) : claim_(claim), all_(claim.reduction) {}

  /// Adds the recordings of one piece of the runs, in the order of all runs.
  void add(std::span<const record::Recording> runs);
  Verdict verdict() const;

 private:
  void add_rows(const record::Recording& runs);
  void add_runs(const Rows& rows);
  void require_value() const;
  void judge_likeness(Verdict& verdict) const;
  double value() const;
  std::string note_of_undefined() const;
  std::string shown(double value, std::optional<std::size_t> worst) const;

  const Claim& claim_;
  Reducing all_;
  std::string missing_ = "nothing was recorded";  ///< Reason why no row can be read.
  std::string trouble_;                           ///< Reason why the current run has no value.
  double worst_ = std::numeric_limits<double>::quiet_NaN();
  double margin_ = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> worst_run_;
  bool differs_ = false;  ///< True if the runs give different values.
  std::size_t runs_ = 0, rows_ = 0, selected_ = 0, undefined_ = 0;
  std::size_t judged_ = 0;       ///< Number of runs that have a value: those of which `where` selects a row.
  LikenessFound like_;           ///< Worst run beside a baseline.
  double magnitude_ = 0.0;       ///< Largest recorded number of the same dimension as the value.
  std::vector<double> numbers_;  ///< One number per selected run, for reductions over several runs.
};

/// True if the claim needs all rows of all runs at once.
bool keeps_rows(const Claim& claim);

}  // namespace stepwire::claim
