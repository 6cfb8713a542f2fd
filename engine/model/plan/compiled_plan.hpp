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

/// What a plan is once it has been compiled: the same calls as the interpreter makes, on the same numbers.
/// `values` is the workspace of a run, `numbers` what it has of the members that the code reads from a table.
struct StepFunctions {
  void (*evaluate)(double* values, const double* numbers, std::int64_t tick) = nullptr;
  void (*advance)(double* values, const double* numbers, std::int64_t tick) = nullptr;
};

/// A plan's code, for runs in which some items have other values.
struct CompiledPlan {
  StepFunctions functions;
  std::vector<VariableBlock> variable;
};

/// In what the runs of a plan differ: members of blocks that code reads from a table, and values of blocks.
struct RunDifferences {
  std::vector<VariableBlock> variable;
  std::vector<diagram::Target> values;
};

/// Code that steps several runs of a plan together.
struct CompiledLanes {
  void (*run)(LaneTask& task) = nullptr;
  int lanes = 0;
  std::vector<VariableBlock> variable;
  std::vector<bool> differs;  ///< numbers of the workspace; all others lie in lane 0 for all runs
};

/// The numbers that compiled code reads, of one run: single ones in their order, behind them the lists. The
/// number in the place of a list is where it begins.
class NumberTable {
 public:
  /// The plan and what varies must outlive it.
  NumberTable(const Plan& plan, const std::vector<VariableBlock>& variable, BlocksOfRun blocks);

  /// Reads a block again after its members have changed; false where code with this table has other numbers
  /// of that block than the run, as they stand in the plan.
  [[nodiscard]] bool read(std::size_t block);
  const double* data() const { return numbers_.data(); }
  std::size_t size() const { return numbers_.size(); }
  /// How many stand before the lists.
  std::size_t singles() const;
  /// Places of numbers that say where a list begins.
  std::vector<std::size_t> list_places() const;

 private:
  struct List {
    std::size_t place, first, size;
  };
  /// What is read of a block.
  struct Entry {
    std::vector<double> singles, in_lists;
    std::vector<List> lists;  ///< with places in these
  };

  Entry entry_of(const VariableBlock& variable, const MemberItems& items) const;
  void lay_out();

  const Plan& plan_;
  const std::vector<VariableBlock>& variable_;
  BlocksOfRun blocks_;
  std::vector<Entry> entries_;
  std::vector<double> numbers_;
};

/// Compares new code with the interpreter before it is trusted.
class CodeTrial {
 public:
  virtual ~CodeTrial() = default;
  /// Returns a sentence on the first fault; an empty one if all numbers are equal.
  virtual std::string fault(const Plan& plan, const CompiledPlan& code) const = 0;
  virtual std::string fault(const Plan& plan, const CompiledLanes& code) const = 0;
};

/// What getting code may take.
struct CodeLimits {
  std::stop_token stop{};  ///< a stop gives up
  bool only_kept = false;  ///< none is compiled: it is there from an earlier time, or there is none
};

/// Where compiled code comes from.
class CodeSource {
 public:
  virtual ~CodeSource() = default;
  /// Compiles a plan; nothing where that cannot be, or not within the limits.
  virtual std::optional<CompiledPlan> compile(const Plan& plan, const std::vector<VariableBlock>& variable,
                                              const CodeLimits& limits) = 0;
  /// Compiles a plan for several runs at once; nothing where that cannot be, or is of no use on this machine:
  /// then `why` has the reason; or not within the limits: then it is empty.
  virtual std::optional<CompiledLanes> compile_lanes(const Plan& plan, const RunDifferences& differences,
                                                     const CodeLimits& limits, std::string& why) = 0;
  /// So many runs go together where compile_lanes() succeeds; 1: it never does on this machine.
  virtual int lanes() = 0;
};

}  // namespace stepwire::plan
