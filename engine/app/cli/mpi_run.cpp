#include "engine/app/cli/mpi_run.hpp"

#include <algorithm>
#include <chrono>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cluster/shared_job.hpp"

namespace stepwire::cli {

using cluster::SharedJob;

namespace {

/// Returns the threads of a process; 1 by default, since many processes share a machine.
unsigned threads_of(unsigned threads) {
  return std::max(1u, threads);
}

cluster::SharedCall shared_call(const RunCall& call) {
  cluster::SharedCall shared{
      call.models.files.front(), load_options(call.models.words), {}, call.fit, call.tune};
  shared.options.study = call.models.study;
  shared.options.threads = threads_of(call.models.threads);
  shared.study = {call.engine, threads_of(call.models.threads)};
  shared.fit.engine = shared.tune.engine = shared.engine = call.engine;
  shared.fit.threads = threads_of(call.fit.threads);
  shared.tune.threads = threads_of(call.tune.threads);
  shared.threads = threads_of(call.models.threads);
  return shared;
}

}  // namespace

ExitCode work_for(messages::Connection& server, const RunCall& call, const Registry& registry) {
  cluster::ItemClient client(server);
  try {
    cluster::JobWorker(registry, shared_call(call), client).work();
  } catch (const std::exception& error) {
    client.fail(error.what());
  }
  return ExitCode::done;
}

session::PointsReport MpiRun::run(session::KeptPoints& points, const session::LoadedModel& model,
                                  const session::Monitor& monitor) {
  const auto start = std::chrono::steady_clock::now();
  cluster::PointItems items(points);
  server_.serve(items, bytes_of(job_of(SharedJob::Kind::points, model)), monitor);
  points.journal().flush();
  say_deaths();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), {}};
}

messages::ItemWorkers& MpiRun::workers(const SharedJob& job, const std::string& folder,
                                       const std::string& follows_from, std::size_t most,
                                       const session::Monitor& monitor) {
  works_.push_back(std::make_unique<cluster::ServedWork>(server_, monitor, job, folder, follows_from, most));
  if (works_.back()->found() > 0) complain("{}\n", works_.back()->state());
  return *works_.back();
}

void MpiRun::say_deaths() {
  for (; said_ < server_.deaths().size(); ++said_) complain("{}\n", server_.deaths()[said_]);
}

void MpiRun::say_kept() const {
  for (const auto& work : works_) complain("{}\n", work->state());
}

void MpiRun::drop() {
  for (const auto& work : works_) work->drop();
}

ExitCode MpiRun::finish(ExitCode code) {
  if (!server_.deaths().empty() && code == ExitCode::interrupted) code = ExitCode::surroundings;
  if (interrupted() || !server_.finish()) messages_.abort(static_cast<int>(code));
  if (code != ExitCode::wrong)
    // With code 2 the other processes gave up because of faults that are already reported.
    say_deaths();
  messages_.finish();
  return code;
}

}  // namespace stepwire::cli
