#include "engine/app/cli/mpi_run.hpp"

#include <chrono>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/session/shared_points.hpp"

namespace stepwire::cli {

void MpiRun::work(const RunCall& call, const Registry& registry) {
  const EndDelay delay(EndDelay::Signals::first);
  session::ServedPoints served(*messages_, &interrupted());
  try {
    session::Session session(registry);
    session.monitor().interrupt = &interrupted();
    session.monitor().progress = [&](double, const std::string&) { served.note_alive(); };
    const session::LoadedModel model =
        session.load(call.models.files.front(), load_options(call.models.words));
    session.run(model, served, call.engine, 1);
  } catch (const std::exception& error) {
    served.fail(error.what());
  }
  whole_ = true;
}

session::Outcome MpiRun::serve(KeptRun& kept, session::Session& session, run::ExecutionMode engine) {
  if (messages_->size() == 1) {
    whole_ = true;
    return kept.run(session, engine);
  }
  return kept.joined([&] {
    const auto start = std::chrono::steady_clock::now();
    session::PointServer server(*messages_, kept.points());
    server.serve(session.monitor());
    for (const std::string& death : server.deaths()) complain("{}\n", death);
    broken_ = !server.deaths().empty();
    whole_ = !broken_ && !interrupted();
    return session::PointsReport{std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), {}};
  });
}

void MpiRun::finish(ExitCode code) {
  if (!whole_) messages_->abort(static_cast<int>(code));
  messages_->finish();
}

}  // namespace stepwire::cli
