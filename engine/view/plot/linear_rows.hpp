#pragma once

#include <string>
#include <vector>

#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

/// The key `of` of plots of linear analyses: the name of one.
PanelKey analysis_key();

/// The results of one analysis, run by run of a sweep, in the runs that `where` selects by their first row.
class LinearRows {
 public:
  LinearRows(const Panel& panel, std::span<const record::Recording> recordings);

  std::size_t runs() const { return runs_.size(); }
  /// A list of a run, `margin.gain`, without what it is filled up with; empty where there is none.
  std::vector<double> list(const std::string& name, std::size_t run) const;
  /// A number of a run; nan where there is none.
  double number(const std::string& name, std::size_t run) const;
  /// How the run is called in the legend: empty for a single one, and where there are many.
  std::string label(std::size_t run) const;
  bool sampled(std::size_t run) const { return number("sample_time", run) > 0.0; }

 private:
  std::size_t first_row(std::size_t run) const { return recording_->starts[runs_[run]]; }

  const Panel& panel_;
  const record::Recording* recording_ = nullptr;
  const table::Table* table_ = nullptr;
  std::string name_;
  std::vector<std::size_t> runs_;  ///< that are shown
};

}  // namespace stepwire::plot
