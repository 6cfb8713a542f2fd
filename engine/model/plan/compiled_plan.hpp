#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/model/plan/change.hpp"

namespace stepwire {

/// What a plan is once it has been compiled: the same calls as the interpreter makes, on the same numbers.
/// `values` is the workspace of a run, `numbers` what it has of the members that the code reads from a table.
struct StepFunctions {
  void (*evaluate)(double* values, const double* numbers, std::int64_t tick) = nullptr;
  void (*advance)(double* values, const double* numbers, std::int64_t tick) = nullptr;
};

/// A plan's code, for runs in which some members have other values.
struct CompiledPlan {
  StepFunctions functions;
  std::vector<VariableBlock> variable;
};

/// The numbers that compiled code reads, of one run: single ones in their order, behind them the lists. The
/// number in the place of a list is where it begins.
class NumberTable {
 public:
  /// `block(i)` is the i-th block of the plan as it is run.
  using Blocks = std::function<const void*(std::size_t)>;

  NumberTable(const Plan& plan, const std::vector<VariableBlock>& variable, const Blocks& blocks);

  /// Reads the numbers again, of all blocks or of one; false where the code does not read all of them.
  void read_all(const Blocks& blocks);
  void read(std::size_t variable, const Blocks& blocks);
  const double* data() const { return numbers_.data(); }
  std::size_t size() const { return numbers_.size(); }

 private:
  class Writer;
  /// Where the numbers of a block lie.
  struct Place {
    std::size_t first_single, singles, first_list, lists;
  };
  struct List {
    std::size_t place, first, size;
  };

  void write(std::size_t variable, const Blocks& blocks, Writer& writer) const;

  const Plan& plan_;
  const std::vector<VariableBlock>& variable_;
  std::vector<Place> places_;
  std::vector<List> lists_;
  std::vector<double> numbers_;
};

/// Where compiled code comes from.
class CodeSource {
 public:
  virtual ~CodeSource() = default;
  /// Compiles a plan; nothing where that cannot be, or a stop gives up.
  virtual std::optional<CompiledPlan> compile(const Plan& plan, const std::vector<VariableBlock>& variable,
                                              const std::stop_token& stop) = 0;
};

}  // namespace stepwire
