#pragma once

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/item_source.hpp"
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

}  // namespace stepwire::cluster
