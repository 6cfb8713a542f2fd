#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

/// Returns the key `of` of plots of linear analyses: the name of an analysis.
PanelKey analysis_key();

/// Results of one analysis, run by run of a sweep, for the runs whose first row `where` selects.
class LinearRows {
 public:
  LinearRows(const Panel& panel, std::span<const record::Recording> recordings);

  std::size_t runs() const { return runs_.size(); }
  /// Returns a list of a run, `margin.gain`, without its padding; an empty list if it is missing.
  std::vector<double> list(const std::string& name, std::size_t run) const;
  /// Returns a number of a run; NaN if it is missing.
  double number(const std::string& name, std::size_t run) const;
  /// Returns the label of the run in the legend; empty for a single run, and for many.
  std::string label(std::size_t run) const;
  bool sampled(std::size_t run) const { return number("sample_time", run) > 0.0; }

 private:
  std::size_t first_row(std::size_t run) const { return recording_->starts[runs_[run]]; }

  const Panel& panel_;
  const record::Recording* recording_ = nullptr;
  const table::Table* table_ = nullptr;
  std::string name_;
  std::vector<std::size_t> runs_;  ///< selected runs
};

}  // namespace stepwire::plot
