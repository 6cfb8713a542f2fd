#pragma once

#include "engine/app/session/signal_files.hpp"

namespace stepwire::session {

/// What a call makes of the rows of the runs of a sweep, beside what claims say of them.
struct RowUse {
  std::string folder{};  ///< for pictures and files; empty: there are none
  FileKinds files{};     ///< of the signals, in the folder
  bool table = false;    ///< one table of all rows, as text
};

/// Is each run of the model's sweep looked at by itself, in their order, so that its rows need not be kept in
/// memory?
bool goes_run_by_run(const LoadedModel& model, const RowUse& use);

/// Refuses, as an Error with the place of each, what needs all rows of all runs at once, where they take more
/// memory than is free.
void require_rows(const LoadedModel& model, const RowUse& use);

}  // namespace stepwire::session
