#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/base/result/record.hpp"
#include "engine/simulate/run/observer.hpp"

namespace stepwire::coverage {

/// One of the ways that a condition of a block can go.
struct Branch {
  std::string name;        ///< "above", "below", "active", the name of a state
  std::int64_t ticks = 0;  ///< Ticks and sides of located events at which the run was there.
};

/// Condition of a block with its branches: a crossing function, a guard, a constant output, a state, a
/// transition.
struct Condition {
  std::string block, type;
  std::string what;  ///< "u reaches the upper limit"
  std::vector<Branch> branches;
  std::int64_t instants = 0;  ///< Ticks and sides of located events at which the block was computed.
  std::int64_t zeros = 0;     ///< Those at which a crossing function was exactly 0.

  std::size_t covered() const;
};

/// Conditions of a diagram, and which branches its runs took.
struct Coverage {
  std::string file{};
  std::vector<Condition> conditions{};

  std::size_t branches() const;
  std::size_t covered() const;
  /// Adds the ticks of other runs of the same diagram; conditions of another structure are appended.
  void add(const Coverage& other);
};

/// Observer that finds the branches of all runs. Conditions follow from declarations: crossing functions,
/// guards, outputs that are constant between crossings, states and transitions of charts. Runs are observed
/// at their ticks and on both sides of each located event, so a branch between two ticks is seen where events
/// are located.
class CoverageObserver : public run::RunObserver {
 public:
  CoverageObserver();
  ~CoverageObserver() override;

  void begin(const run::ObservedRun& run) override;
  void evaluated(const run::ObservedRun& run) override;
  void end(const run::ObservedRun& run) override;

  /// Returns the coverage of all runs that have ended.
  Coverage coverage() const;

 private:
  class OfRun;

  mutable std::mutex mutex_;
  std::map<std::size_t, std::unique_ptr<OfRun>> runs_;
  Coverage all_;
};

/// Returns the coverage in words: a count, and each branch that no run took.
std::string coverage_text(const Coverage& coverage);

/// Declares the fields of the result of `run --coverage --json`.
void declare(result::Record<Coverage>& is);

}  // namespace stepwire::coverage
