#include "engine/app/cluster/served_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/app/session/kept_points.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/journal/point_bytes.hpp"

namespace stepwire::cluster {

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
