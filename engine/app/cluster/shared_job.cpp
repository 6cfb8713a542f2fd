#include "engine/app/cluster/shared_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/base/hash/hash.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/journal/point_bytes.hpp"
#include "engine/simulate/journal/run_bytes.hpp"

namespace stepwire::cluster {

namespace {

template <class Stream, class Settings>
void settings(Stream& stream, Settings& of) {
  list(stream, of, [&](auto& one) { journal::setting(stream, one); });
}

template <class Stream, class Job>
void parts(Stream& stream, Job& job) {
  all(stream, job.kind);
  settings(stream, job.settings);
  list(stream, job.of_points, [&](auto& one) { settings(stream, one); });
}

}  // namespace

SharedJob job_of(SharedJob::Kind kind, const session::LoadedModel& model) {
  return {kind, model.options.settings, model.options.of_points};
}

const char* name_of(SharedJob::Kind kind) {
  constexpr std::array names{"sweep", "study", "fit", "tune"};
  return names[static_cast<std::size_t>(kind)];
}

std::string bytes_of(const SharedJob& job) {
  messages::ByteWriter writer;
  parts(writer, job);
  return writer.take();
}

std::optional<SharedJob> job_of(std::string_view bytes) {
  messages::ByteReader reader(bytes);
  SharedJob job;
  parts(reader, job);
  if (!reader.whole() || job.kind > SharedJob::Kind::tune) return std::nullopt;
  return job;
}

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

std::optional<std::size_t> ServedPoints::next() {
  const auto item = client_.next();
  return item ? std::optional(item->number) : std::nullopt;
}

void ServedPoints::take(run::PointResult result) {
  if (result.end.interrupted) return;
  client_.put(result.point, journal::Journal::record_of(journal::bytes_of(result)));
}

ServedWork::ServedWork(ItemServer& server, const session::Monitor& monitor, const SharedJob& job,
                       const std::string& folder, const std::string& follows_from, std::size_t most)
    : server_(server),
      monitor_(monitor),
      kind_(job.kind),
      bytes_(bytes_of(job)),
      kept_(session::items_path(folder, name_of(job.kind)), hash::hash_of(follows_from), most),
      found_(kept_.kept()) {}

std::vector<std::string> ServedWork::run(const std::vector<messages::Item>& items) {
  kept_.want(items);
  wanted_ = items.size();
  if (kept_.left() > 0) server_.serve(kept_, bytes_, monitor_);
  const auto kept = [&](const messages::Item& item) { return kept_.has(item); };
  if (std::ranges::all_of(items, kept)) return kept_.results(items);
  if (monitor_.interrupted()) throw subprocess::ProcessStopped(state());
  throw io::EnvironmentError(state());
}

std::string ServedWork::state() const {
  return fmt::format("{}: {} of {} are kept; the same call goes on", kept_.path(), kept_.kept(),
                     kind_ == SharedJob::Kind::study ? "the study's people and experiments" : "the searches");
}

void ServedWork::drop() {
  std::filesystem::remove(kept_.path());
}

}  // namespace stepwire::cluster
