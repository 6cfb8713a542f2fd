#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::estimation {

/// The blocks of a diagram that fitted parameters affect and that the compared columns depend on. All other
/// signals are the same in every run of a record. They are computed once, and those that the part reads are
/// replayed from a tape. A run then costs the part only.
class SensitiveSubdiagram {
 public:
  /// Finds the part for a plan, the variation of the fitted parameters and the compared columns. Returns
  /// std::nullopt if the part reads a signal that changes between ticks and the solver evaluates it there.
  /// Likewise if a condition ends the run, or if the part is empty or the whole.
  static std::optional<SensitiveSubdiagram> find(const plan::Plan& plan, const diagram::Variation& moved,
                                                 const std::vector<std::string>& columns);

  /// Returns the part of the same diagram with other numbers; its inputs are those of `tape`, in order.
  diagram::Diagram of(const diagram::Diagram& diagram) const;
  /// Returns the number of inputs per tick.
  std::size_t width() const { return offsets_.size(); }
  /// Appends the signals that the part reads at this tick, in a run of the whole diagram.
  void append(const double* values, std::vector<double>& tape) const {
    for (const std::size_t offset : offsets_) tape.push_back(values[offset]);
  }
  /// Writes the recorded signals of the present tick into a run of the part.
  void play(const std::vector<double>& tape, run::Executor& simulation) const;
  /// True if the part computes this recorded column.
  bool gives(const std::string& column) const;

 private:
  /// An output that the part reads, and its rate.
  struct Read {
    diagram::SignalRef signal;
    Eigen::Index size;
    plan::Rate rate;
  };

  SensitiveSubdiagram() = default;
  void keep_ancestors(const diagram::Diagram& diagram, const std::vector<std::string>& columns);
  bool find_reads(const plan::Plan& plan);
  diagram::DiagramBlock input(const diagram::Diagram& diagram, const Read& read) const;
  /// Copies the kept blocks. Returns the new index of each block, -1 for the others.
  std::vector<int> keep_blocks(const diagram::Diagram& diagram, diagram::Diagram& part) const;
  /// Returns the source of an input within the part; `first_read` is the block of its first read output.
  diagram::Source moved(diagram::Source source, const std::vector<int>& place, int first_read) const;

  std::vector<char> kept_;  ///< Marks of kept blocks.
  std::vector<Read> reads_;
  std::vector<std::size_t> offsets_;  ///< Offsets of all read numbers in the workspace of the whole diagram.
  std::vector<std::string> recorded_;
};

}  // namespace stepwire::estimation
