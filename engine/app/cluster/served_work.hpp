#pragma once

#include "engine/app/cluster/item_server.hpp"
#include "engine/app/cluster/kept_items.hpp"
#include "engine/app/cluster/shared_job.hpp"

namespace stepwire::cluster {

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
