#pragma once

#include "engine/app/session/signal_files.hpp"

namespace stepwire::session {

/// Outputs of a call that need rows of a sweep's runs. Claims are not included.
struct RowUse {
  std::string folder{};  ///< folder of pictures and files; empty: none
  FileKinds files{};     ///< kinds of signal files in the folder
  bool table = false;    ///< one text table of all rows
};

/// True if the runs can be processed one by one in order, so that their rows need not stay in memory.
bool goes_run_by_run(const LoadedModel& model, const RowUse& use);

/// Throws Error with the place of each output that needs the rows of all runs at once, if these exceed the
/// free memory.
void require_rows(const LoadedModel& model, const RowUse& use);

}  // namespace stepwire::session
