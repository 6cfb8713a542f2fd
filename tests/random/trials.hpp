#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/random/laws.hpp"

namespace stepwire::random {

/// Counts of a law over all diagrams.
struct LawCount {
  std::size_t meant = 0;  ///< diagrams on which it was tried
  std::size_t same = 0, different = 0;
  std::size_t located = 0;                       ///< of those that were compared, in runs that located events
  std::map<std::string, std::size_t> skipped{};  ///< by the reason
};

/// A law that a diagram breaks.
struct Failure {
  std::uint64_t seed;
  const Law* law;
  Sketch sketch;
  std::string text;
};

/// Counts over all diagrams.
struct Totals {
  std::size_t valid = 0;
  std::map<std::string, std::size_t> refused{};  ///< by the message, without names and numbers
  std::size_t ended = 0;                         ///< by a fault
  std::map<std::string, std::size_t> types{};    ///< diagrams with a block of this type
  std::vector<LawCount> laws{};                  ///< parallel to laws()
  std::vector<Failure> failures{};

  std::size_t all() const;
};

/// Tries laws on random diagrams.
class Trials {
 public:
  /// The folder has the data files of diagrams.
  Trials(const Registry& registry, std::string folder);

  /// Tries all laws on the diagrams of these seeds, those about code on the first `with_code` of them. Code
  /// of a batch of diagrams is compiled together.
  void run(std::uint64_t first, std::size_t count, std::size_t with_code);
  const Totals& totals() const { return totals_; }

  /// Checks one law on several diagrams; those that are refused are skipped.
  std::vector<Verdict> check(const Law& law, std::uint64_t seed, const std::vector<Sketch>& sketches);

 private:
  /// A law of a trial, and its verdict.
  struct Check {
    const Trial* trial;
    std::size_t law;
    Verdict verdict{};
  };

  std::vector<Trial> valid_of(std::uint64_t first, std::size_t count);
  void count_types(const plan::Plan& plan);
  std::vector<Check> checks_of(const std::vector<Trial>& trials, std::uint64_t end_of_code) const;
  void check_all(std::vector<Check>& checks);
  void count(const Check& check);
  Verdict checked(const Law& law, const Trial& trial);

  const Registry& registry_;
  std::string folder_;
  BatchCode code_;
  Totals totals_;
};

/// Counts as lines of text.
std::string totals_text(const Totals& totals);
/// The reason for which the counts prove too little: too many refused, a law that is hardly compared, a type
/// that is missing; empty if there is none.
std::string weakness_of(const Totals& totals, const Registry& registry);

}  // namespace stepwire::random
