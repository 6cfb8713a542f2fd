#include "engine/app/cli/kept_run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"

namespace stepwire::cli {

KeptRun::KeptRun(const session::LoadedModel& model, const session::RowUse& use, const session::Share& share)
    : model_(model), use_(use), folder_(use.folder), share_(share), kept_(model, use.folder, share) {
  if (kept_.found() > 0)
    complain("{}: {} of {} points are there from an earlier call\n", folder_, kept_.found(), kept_.points());
}

session::Outcome KeptRun::run(session::Session& session, run::ExecutionMode engine, unsigned threads) {
  return joined(session.run(model_, kept_, engine, threads));
}

session::Outcome KeptRun::joined(const session::PointsReport& report) {
  session::Outcome outcome = session::joined_points(model_, {&kept_.journal()}, use_, kept_.take_halves());
  outcome.seconds = report.seconds;
  outcome.result.lanes = report.lanes;
  if (outcome.result.interrupted) note_interrupted();
  return outcome;
}

ExitCode KeptRun::run_share(session::Session& session, run::ExecutionMode engine, unsigned threads) {
  session.run(model_, kept_, engine, threads);
  return end_share();
}

ExitCode KeptRun::end_share() {
  kept_.journal().flush();
  if (interrupted() || kept_.kept() < kept_.points()) {
    note_interrupted();
    return ExitCode::interrupted;
  }
  say("{}: share {} of {}, {} of {} points; when all shares are there: stepwire collect DIR... --out DIR\n",
      folder_, share_.number, share_.count, kept_.points(), model_.job.points.size());
  return ExitCode::done;
}

void KeptRun::note_interrupted() {
  complain("{}: {} of {} points are kept; the same call goes on\n", folder_, kept_.kept(), kept_.points());
}

void KeptRun::drop() {
  std::filesystem::remove(session::points_path(folder_));
}

session::Share share_of(const std::string& text) {
  session::Share share;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, share.number);
  const bool parted = number.ec == std::errc{} && number.ptr != end && *number.ptr == '/';
  const auto count = parted ? std::from_chars(number.ptr + 1, end, share.count) : number;
  if (!parted || count.ec != std::errc{} || count.ptr != end || share.number < 1 ||
      share.number > share.count)
    throw CLI::ValidationError("--part",
                               fmt::format("is K/N, the share K of N from 1/N to N/N, not '{}'", text));
  return share;
}

}  // namespace stepwire::cli
