#include "engine/app/cli/kept_run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <future>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/base/parallel/parallel.hpp"

namespace stepwire::cli {

namespace {

/// Scope guard for following a journal; ends the following even after an exception.
class Followed {
 public:
  explicit Followed(journal::Journal& journal) : journal_(journal) { journal_.follow(); }
  ~Followed() { journal_.end_following(); }
  Followed(const Followed&) = delete;
  Followed& operator=(const Followed&) = delete;

 private:
  journal::Journal& journal_;
};

}  // namespace

KeptRun::KeptRun(const session::LoadedModel& model, const session::RowUse& use, const session::Share& share)
    : model_(model), use_(use), folder_(use.folder), share_(share), kept_(model, use.folder, share) {
  if (kept_.found() > 0)
    complain("{}: {} of {} points are there from an earlier call\n", folder_, kept_.found(), kept_.points());
}

session::Outcome KeptRun::run(session::Session& session, run::ExecutionMode engine, unsigned threads) {
  return joined([&] { return session.run(model_, kept_, engine, threads); });
}

session::Outcome KeptRun::joined(const std::function<session::PointsReport()>& run) {
  std::packaged_task<session::Outcome()> task(
      [&] { return session::joined_points(model_, {&kept_.journal()}, use_, &kept_); });
  const std::function<void()> join = [&] { task(); };
  std::vector<std::jthread> writer;
  const Followed followed(kept_.journal());
  // Writes runs during the sweep if their files allow it. Otherwise the join needs all rows at once, and
  // waits for the end to save memory.
  if (session::goes_run_by_run(model_, use_)) writer = parallel::begin_threads(2, join);
  const session::PointsReport report = run();
  kept_.journal().end_following();
  if (writer.empty()) join();
  session::Outcome outcome = task.get_future().get();
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
