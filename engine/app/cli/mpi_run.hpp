#pragma once

#include <memory>
#include <vector>

#include "engine/app/cli/kept_run.hpp"
#include "engine/app/cli/run_call.hpp"
#include "engine/app/cluster/served_work.hpp"
#include "engine/base/messages/messages.hpp"

namespace stepwire::cli {

/// Process 0 of those of mpirun: it keeps and writes, and the others run points of a sweep, people of a
/// study, and searches of a fit or a tuning.
class MpiRun {
 public:
  explicit MpiRun(messages::Messages& messages) : messages_(messages), server_(messages) {}

  /// Are there others?
  bool shares() const { return messages_.size() > 1; }
  /// Has the others run the points of a model, and joins them.
  session::Outcome run(KeptRun& kept, const session::LoadedModel& model, const session::Monitor& monitor);
  /// Has the others run those of a share.
  ExitCode run_share(KeptRun& kept, const session::LoadedModel& model, const session::Monitor& monitor);
  /// The others, for a job of a model whose items follow from a text and are so many at most. They stay until
  /// the call's end.
  messages::ItemWorkers& workers(const cluster::SharedJob& job, const std::string& folder,
                                 const std::string& follows_from, std::size_t most,
                                 const session::Monitor& monitor);
  /// Says which processes have died since it was said last.
  void say_deaths();
  /// Says what is kept of searches and people.
  void say_kept() const;
  /// Once all results are written: what was kept of searches and people goes.
  void drop();
  /// Ends all processes, where some of them may not come to their end at once, and gives the status of the
  /// call that ends with `code`.
  ExitCode finish(ExitCode code);

 private:
  void serve(KeptRun& kept, const session::LoadedModel& model, const session::Monitor& monitor);

  messages::Messages& messages_;
  cluster::ItemServer server_;
  std::vector<std::unique_ptr<cluster::ServedWork>> works_;
  std::size_t said_ = 0;
};

/// Works for process 0 until it has no more. Says nothing: what goes wrong is said by process 0.
ExitCode work_for(messages::Connection& server, const RunCall& call, const Registry& registry);

}  // namespace stepwire::cli
