#pragma once

#include "engine/app/cluster/item_server.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/shared_job.hpp"

namespace stepwire::cluster {

/// Items of one job of a model that other processes do, kept in its folder.
class ServedWork : public messages::ItemWorkers {
 public:
  /// `follows_from` is all that decides what comes out of the job's items, of which there are so many at
  /// most. What is given must outlive it. Throws EnvironmentError.
  ServedWork(ItemServer& server, const session::Monitor& monitor, const SharedJob& job,
             const std::string& folder, const std::string& follows_from, std::size_t most);

  std::vector<std::string> run(const std::vector<messages::Item>& items) override;
  /// How many items an earlier call has left.
  std::size_t found() const { return found_; }
  /// "3 of 8 searches are kept; the same call goes on".
  std::string state() const;
  /// Once the results are written: the items go.
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
