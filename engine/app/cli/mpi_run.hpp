#pragma once

#include "engine/app/cli/kept_run.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::cli {

/// A run of a sweep by the processes of mpirun: process 0 keeps the points, and writes, and the others run
/// them.
class MpiRun {
 public:
  /// Throws EnvironmentError where the program was built without MPI.
  MpiRun() : messages_(messages::open_mpi()) {}

  bool is_worker() const { return messages_->rank() > 0; }
  /// Runs points that process 0 gives to this one, of the call's one file. Says nothing: what goes wrong is
  /// said by process 0.
  void work(const RunCall& call, const Registry& registry);
  /// Has the others run the points, and joins them; alone, process 0 runs them itself.
  session::Outcome serve(KeptRun& kept, session::Session& session, run::ExecutionMode engine);
  /// Were points lost with a process?
  bool broken() const { return broken_; }
  /// Ends all processes; where some of them may not come to the end, at once and with this code.
  void finish(ExitCode code);

 private:
  std::unique_ptr<messages::Messages> messages_;
  bool broken_ = false;
  bool whole_ = false;  ///< have all processes come to the end of the points?
};

}  // namespace stepwire::cli
