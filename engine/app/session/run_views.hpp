#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/table/run_view.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::session {

/// The runs of a recording one by one, for files with a place for each. The recording must outlive this and
/// the views.
class RunViews {
 public:
  /// `first` is the index of the recording's first run among all runs, `number` that of the recording.
  RunViews(const LoadedModel& model, const record::Recording& recording, std::size_t first = 0,
           std::size_t number = 0);

  std::size_t count() const { return swept_.empty() ? 1 : recording_.starts.size(); }
  /// A run without rows has empty columns, and no values of what it sets.
  table::RunView view(std::size_t run) const;

 private:
  std::span<const std::string> words_of(const std::string& column) const;

  const record::Recording& recording_;
  std::size_t first_;
  std::vector<std::size_t> points_{};      ///< of the runs, where the recording has some of them; else empty
  std::set<std::string> swept_;            ///< columns that are one value in each run
  std::vector<record::Categories> words_;  ///< without quotes
};

}  // namespace stepwire::session
