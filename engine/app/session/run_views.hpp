#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/table/run_view.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::session {

/// Views of the single runs in a recording, for files with one group per run. The recording must outlive the
/// object and its views.
class RunViews {
 public:
  /// `first` is the index of the recording's first run among all runs; `number` is the index of the
  /// recording.
  RunViews(const LoadedModel& model, const record::Recording& recording, std::size_t first = 0,
           std::size_t number = 0);

  std::size_t count() const { return swept_.empty() ? 1 : recording_.starts.size(); }
  /// Returns the view of a run. A run without rows has empty columns and no swept values.
  table::RunView view(std::size_t run) const;

 private:
  std::span<const std::string> words_of(const std::string& column) const;

  const record::Recording& recording_;
  std::size_t first_;
  std::vector<std::size_t> points_{};      ///< Indices of the runs if only some are recorded; else empty.
  std::set<std::string> swept_;            ///< Columns with one value per run.
  std::vector<record::Categories> words_;  ///< Texts without quotes.
};

}  // namespace stepwire::session
