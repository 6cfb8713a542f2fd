#pragma once

#include <optional>
#include <string>

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/shared_job.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cluster {

/// What all processes of a call know of it.
struct SharedCall {
  std::string file;
  session::LoadOptions options;
  session::StudyCall study;
  session::FitCall fit;
  session::TuneCall tune;
  run::ExecutionMode engine = run::ExecutionMode::automatic;
  unsigned threads = 1;  ///< of a process
};

/// Does the jobs that process 0 gives to this one.
class JobWorker {
 public:
  JobWorker(const Registry& registry, SharedCall call, ItemClient& client);

  /// Until there are no more. What goes wrong is said by process 0.
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
  std::string job_;  ///< that stands in the members below
  std::optional<session::LoadedModel> model_;
  messages::ItemWork item_work_;  ///< empty: points of a sweep
};

}  // namespace stepwire::cluster
