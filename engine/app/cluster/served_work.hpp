#pragma once

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/item_server.hpp"
#include "engine/app/cluster/item_source.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/shared_job.hpp"
#include "engine/app/session/kept_points.hpp"

namespace stepwire::cluster {

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
