#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/item_server.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/session.hpp"

namespace stepwire::cluster {

/// Job that several processes run together on one file.
struct SharedJob {
  enum class Kind : std::uint8_t { points, study, fit, tune };

  Kind kind = Kind::points;
  std::vector<diagram::Setting> settings{};  ///< settings of the load, with fitted values
  run::PointSettings of_points{};
};

/// Returns the job of this kind for a loaded model.
SharedJob job_of(SharedJob::Kind kind, const session::LoadedModel& model);
/// Returns "sweep", "study", "fit" or "tune".
const char* name_of(SharedJob::Kind kind);

std::string bytes_of(const SharedJob& job);
/// Parses the bytes of bytes_of(); std::nullopt if they are malformed.
std::optional<SharedJob> job_of(std::string_view bytes);

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

/// Points of a sweep as items; the results are appended to the sweep's journal.
class PointItems : public ItemSource {
 public:
  explicit PointItems(session::KeptPoints& kept) : kept_(kept) {}

  std::optional<messages::Item> next() override {
    const auto point = kept_.next();
    return point ? std::optional(messages::Item{*point}) : std::nullopt;
  }
  std::size_t left() const override { return kept_.left(); }
  void take(std::size_t number, std::string_view bytes) override {
    kept_.journal().add_record(number, bytes);
  }
  double done() const override { return kept_.done(); }

 private:
  session::KeptPoints& kept_;
};

/// Points of a sweep that process 0 distributes, as seen by a worker.
class ServedPoints : public run::PointExchange {
 public:
  explicit ServedPoints(ItemClient& client) : client_(client) {}

  std::optional<std::size_t> next() override;
  void take(run::PointResult result) override;
  double done() const override { return 0.0; }

 private:
  ItemClient& client_;
};

/// Item runner that uses the worker processes, with a journal in the job's folder.
class ServedWork : public messages::ItemWorkers {
 public:
  /// `follows_from` is the text that determines all results of the job; `most` is the largest number of
  /// items. The arguments must outlive the object. Throws EnvironmentError.
  ServedWork(ItemServer& server, const session::Monitor& monitor, const SharedJob& job,
             const std::string& folder, const std::string& follows_from, std::size_t most);

  std::vector<std::string> run(const std::vector<messages::Item>& items) override;
  /// Returns the number of results that an earlier call left.
  std::size_t found() const { return found_; }
  /// Returns a note on the stored results, "3 of 8 searches are kept ...".
  std::string state() const;
  /// Removes the journal, after the results are written.
  void drop();

 private:
  ItemServer& server_;
  const session::Monitor& monitor_;
  const SharedJob::Kind kind_;
  const std::string bytes_;
  KeptItems kept_;
  std::size_t found_, wanted_ = 0;
};

}  // namespace stepwire::cluster
