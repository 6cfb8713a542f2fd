#pragma once

#include <optional>
#include <string>

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/shared_job.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cluster {

/// Arguments of a call that all its processes have.
struct SharedCall {
  std::string file;
  session::LoadOptions options;
  session::StudyCall study;
  session::FitCall fit;
  session::TuneCall tune;
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  unsigned threads = 1;  ///< threads per process
};

/// Worker that runs the jobs which process 0 distributes.
class JobWorker {
 public:
  JobWorker(const Registry& registry, SharedCall call, ItemClient& client);

  /// Works until there are no more jobs. Faults are sent to process 0, which reports them.
  void work();

 private:
  void work(const std::string& job);
  void begin(const SharedJob& job);
  messages::ItemWork work_of(SharedJob::Kind kind) const;
  void run_points();

  const Registry& registry_;
  const SharedCall call_;
  ItemClient& client_;
  session::Session session_;
  std::string job_;  ///< the job that is loaded into the members below
  std::optional<session::LoadedModel> model_;
  messages::ItemWork item_work_;  ///< empty: the items are points of a sweep
};

}  // namespace stepwire::cluster
