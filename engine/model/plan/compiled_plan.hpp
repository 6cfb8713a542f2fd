#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/model/plan/lane_task.hpp"
#include "engine/model/plan/member_items.hpp"
#include "engine/model/plan/variable_blocks.hpp"

namespace stepwire::plan {

/// Compiled step functions of a plan. They make the same calls as the interpreter, on the same numbers.
/// `values` is the workspace of a run, `numbers` its table of the members that the code does not contain as
/// literals.
struct StepFunctions {
  void (*evaluate)(double* values, const double* numbers, std::int64_t tick) = nullptr;
  void (*advance)(double* values, const double* numbers, std::int64_t tick) = nullptr;
};

/// Compiled code of a plan, and the items that it reads from a table.
struct CompiledPlan {
  StepFunctions functions;
  std::vector<VariableBlock> variable;
};

/// Differences between the runs of a plan: members that code reads from a table, and values of blocks.
struct RunDifferences {
  std::vector<VariableBlock> variable;
  std::vector<diagram::Target> values;
};

/// Compiled code that steps a lane batch of a plan.
struct CompiledLanes {
  void (*run)(LaneTask& task) = nullptr;
  int lanes = 0;
  std::vector<VariableBlock> variable;
  std::vector<bool> differs;  ///< numbers stored for each lane; all others are shared, in lane 0
};

/// Table of the numbers that compiled code reads in one run: single numbers in order, then the lists. The
/// entry of a list is the index at which it begins.
class NumberTable {
 public:
  /// The plan and the variable blocks must outlive the table.
  NumberTable(const Plan& plan, const std::vector<VariableBlock>& variable, BlocksOfRun blocks);

  /// Reads a block again after its members have changed. Returns false where a literal in the code now
  /// differs from the member of the run.
  [[nodiscard]] bool read(std::size_t block);
  const double* data() const { return numbers_.data(); }
  std::size_t size() const { return numbers_.size(); }
  /// Returns the number of entries before the lists.
  std::size_t singles() const;
  /// Returns the indices of the entries that hold the begin of a list.
  std::vector<std::size_t> list_places() const;

 private:
  struct List {
    std::size_t place, first, size;
  };
  /// Entries of one block.
  struct Entry {
    std::vector<double> singles, in_lists;
    std::vector<List> lists;  ///< `place` in `singles`, `first` in `in_lists`
  };

  Entry entry_of(const VariableBlock& variable, const MemberItems& items) const;
  void lay_out();

  const Plan& plan_;
  const std::vector<VariableBlock>& variable_;
  BlocksOfRun blocks_;
  std::vector<Entry> entries_;
  std::vector<double> numbers_;
};

/// Comparison of new code with the interpreter before its first use.
class CodeTrial {
 public:
  virtual ~CodeTrial() = default;
  /// Returns a sentence about the first difference; an empty one if all numbers are equal.
  virtual std::string fault(const Plan& plan, const CompiledPlan& code) const = 0;
  virtual std::string fault(const Plan& plan, const CompiledLanes& code) const = 0;
};

/// Limits on obtaining compiled code.
struct CodeLimits {
  std::stop_token stop{};  ///< cancels the compilation
  bool only_kept = false;  ///< uses the cache only and never compiles
};

/// Provider of compiled code.
class CodeSource {
 public:
  virtual ~CodeSource() = default;
  /// Compiles a plan. Returns std::nullopt if that is impossible or exceeds the limits.
  virtual std::optional<CompiledPlan> compile(const Plan& plan, const std::vector<VariableBlock>& variable,
                                              const CodeLimits& limits) = 0;
  /// Compiles a plan for a lane batch. Returns std::nullopt if that is impossible or useless on this machine,
  /// with the reason in `why`. Returns std::nullopt with an empty `why` where the limits are exceeded.
  virtual std::optional<CompiledLanes> compile_lanes(const Plan& plan, const RunDifferences& differences,
                                                     const CodeLimits& limits, std::string& why) = 0;
  /// Returns the number of lanes for which compile_lanes() compiles; 1 if this machine never uses lanes.
  virtual int lanes() = 0;
};

}  // namespace stepwire::plan
