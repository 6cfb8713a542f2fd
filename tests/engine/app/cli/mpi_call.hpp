#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/engine/app/cli/program.hpp"

/// True if mpirun can run the program here; otherwise prints a warning with the reason.
bool has_mpi();

/// Three processes of mpirun run the program in a folder with these words; `meanwhile` is called beside them,
/// in the calling thread. The code is that of mpirun.
Done run_by_three(const Scratch& folder, const std::vector<std::string>& words,
                  const std::function<void()>& meanwhile = {});

/// The processes of the call in a folder, once its journal of that name keeps a first result, so that all are
/// at work.
struct MpiProcesses {
  std::vector<pid_t> ranks;    ///< those that mpirun has begun, but that which writes
  std::vector<pid_t> workers;  ///< and those that work for them
};
MpiProcesses processes_at_work(const Scratch& folder, const std::string& journal);
