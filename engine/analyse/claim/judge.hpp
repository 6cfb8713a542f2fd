#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// Judges a claim on runs that come one behind the other, in pieces, without keeping their rows where it can.
class Judge {
 public:
  /// The claim must outlive it.
  explicit Judge(const Claim& claim) : claim_(claim), all_(claim.reduction) {}

  /// Adds the runs of a piece: what they recorded, as all of them have it together.
  void add(std::span<const record::Recording> runs);
  Verdict verdict() const;

 private:
  void add_rows(const record::Recording& runs);
  void add_runs(const Rows& rows);
  void require_value() const;
  double value() const;
  std::string note_of_undefined() const;
  std::string shown(double value, std::optional<std::size_t> worst) const;

  const Claim& claim_;
  Reducing all_;
  std::string missing_ = "nothing was recorded";  ///< why no row can be looked at
  std::string trouble_;                           ///< why the run that is looked at has no value
  double worst_ = std::numeric_limits<double>::quiet_NaN();
  double margin_ = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> worst_run_;
  bool differs_ = false;  ///< not all runs give the same value
  std::size_t runs_ = 0, rows_ = 0, selected_ = 0, undefined_ = 0;
  double magnitude_ = 0.0;       ///< of the recorded quantities of the reduced one's kind
  std::vector<double> numbers_;  ///< one of each run that counts, of a claim about several runs
};

/// Has a claim to see all rows of all runs at once?
bool keeps_rows(const Claim& claim);

}  // namespace stepwire::claim
