#include "engine/app/cluster/job_worker.hpp"

#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/served_work.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::cluster {

JobWorker::JobWorker(const Registry& registry, SharedCall call, ItemClient& client)
    : registry_(registry), call_(std::move(call)), client_(client), session_(registry) {}

void JobWorker::work() {
  try {
    while (const auto job = client_.next_job()) work(*job);
  } catch (const std::exception& error) {
    client_.fail(error.what());
  }
}

void JobWorker::work(const std::string& job) {
  if (job != job_) {
    const auto read = job_of(job);
    if (!read) throw io::EnvironmentError("process 0 is another build of the program");
    begin(*read);
    job_ = job;
  }
  if (!item_work_) return run_points();
  while (const auto item = client_.next()) try {
      client_.put(item->number, KeptItems::record_of(item->number, item_work_(*item)));
    } catch (const yaml::Error& error) {
      client_.refuse(error);
    }
}

void JobWorker::begin(const SharedJob& job) {
  item_work_ = nullptr;  // The work refers to the model, which is replaced below.
  session::LoadOptions options = call_.options;
  options.settings = job.settings;
  options.of_points = job.of_points;
  model_ = session_.load(call_.file, options);
  item_work_ = work_of(job.kind);
}

messages::ItemWork JobWorker::work_of(SharedJob::Kind kind) const {
  switch (kind) {
    case SharedJob::Kind::study:
      return session::study_work(registry_, *model_, call_.study);
    case SharedJob::Kind::fit:
      return session::fit_work(registry_, *model_, call_.fit);
    case SharedJob::Kind::tune:
      return session::tune_work(registry_, *model_, call_.tune);
    default:
      return nullptr;
  }
}

void JobWorker::run_points() {
  ServedPoints served(client_);
  session_.run(*model_, served, call_.engine, call_.threads);
}

}  // namespace stepwire::cluster
