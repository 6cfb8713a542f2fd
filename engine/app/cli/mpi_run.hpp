#pragma once

#include <memory>
#include <vector>

#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/app/cluster/shared_job.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::cli {

/// Process 0 of an mpirun call. It writes journals and results; the other processes run points of a sweep,
/// subjects of a study, and searches of a fit or an optimisation.
class MpiRun {
 public:
  explicit MpiRun(messages::Messages& messages) : messages_(messages), server_(messages) {}

  /// True if there are other processes.
  bool shares() const { return messages_.size() > 1; }
  /// Distributes the points of a journal to the other processes.
  session::PointsReport run(session::KeptPoints& points, const session::LoadedModel& model,
                            const session::Monitor& monitor);
  /// Returns the other processes as workers for a job. `follows_from` determines the results of the items,
  /// and `most` is their largest number. The workers exist until the end of the call.
  messages::ItemWorkers& workers(const cluster::SharedJob& job, const std::string& folder,
                                 const std::string& follows_from, std::size_t most,
                                 const session::Monitor& monitor);
  /// Prints the deaths of processes since the last call.
  void say_deaths();
  /// Prints the state of the journals of searches and subjects.
  void say_kept() const;
  /// Removes the journals of searches and subjects, after all results are written.
  void drop();
  /// Ends all processes, by force if some do not respond, and returns the exit code of a call that ends with
  /// `code`.
  ExitCode finish(ExitCode code);

 private:
  messages::Messages& messages_;
  cluster::ItemServer server_;
  std::vector<std::unique_ptr<cluster::ServedWork>> works_;
  std::size_t said_ = 0;
};

/// Works for process 0 until there are no more jobs. It prints nothing, because process 0 reports the faults.
ExitCode work_for(messages::Connection& server, const RunCall& call, const Registry& registry);

}  // namespace stepwire::cli
