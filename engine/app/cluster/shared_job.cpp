#include "engine/app/cluster/shared_job.hpp"

#include <array>

#include "engine/base/messages/bytes.hpp"
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

}  // namespace stepwire::cluster
