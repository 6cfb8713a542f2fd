#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::estimation {

/// The part of a diagram that fitted parameters move and that what is compared depends on. All else gives the
/// same in every run of a record: it is run once, and what the part reads of it is played back.
class SensitiveSubdiagram {
 public:
  /// Of a plan and what changes in it; `columns` are those that are compared. Nothing where the part reads a
  /// signal that changes between ticks and the solver looks there, or where a condition ends the run.
  static std::optional<SensitiveSubdiagram> find(const plan::Plan& plan, const diagram::Variation& moved,
                                                 const std::vector<std::string>& columns);

  /// The part of the same diagram with other numbers, its inputs being those of `tape`, in their order.
  diagram::Diagram of(const diagram::Diagram& diagram) const;
  /// How many numbers the inputs are at a tick.
  std::size_t width() const { return offsets_.size(); }
  /// Appends what the part reads at this tick of a run of the whole diagram.
  void append(const double* values, std::vector<double>& tape) const {
    for (const std::size_t offset : offsets_) tape.push_back(values[offset]);
  }
  /// Writes what was read at the present tick into a run of the part.
  void play(const std::vector<double>& tape, run::Executor& simulation) const;
  /// Does the part give this recorded column?
  bool gives(const std::string& column) const;

 private:
  /// An output that the part reads, and how it changes.
  struct Read {
    diagram::SignalRef signal;
    Eigen::Index size;
    plan::Rate rate;
  };

  SensitiveSubdiagram() = default;
  void keep_ancestors(const diagram::Diagram& diagram, const std::vector<std::string>& columns);
  bool find_reads(const plan::Plan& plan);
  diagram::DiagramBlock input(const diagram::Diagram& diagram, const Read& read) const;
  /// Copies the blocks that are kept; where each is then, -1 for the others.
  std::vector<int> keep_blocks(const diagram::Diagram& diagram, diagram::Diagram& part) const;
  /// What feeds an input of the part; `first_read` is the block of the first output that it reads.
  diagram::Source moved(diagram::Source source, const std::vector<int>& place, int first_read) const;

  std::vector<char> kept_;  ///< blocks
  std::vector<Read> reads_;
  std::vector<std::size_t> offsets_;  ///< of all that is read, in the workspace of the whole
  std::vector<std::string> recorded_;
};

}  // namespace stepwire::estimation
