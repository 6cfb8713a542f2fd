#pragma once

#include <memory>
#include <utility>

namespace stepwire {

/// Snapshot of a run, which may be restored any number of times; copies share it. It holds the mutable state
/// without the parameters, which keep their present values in a restore.
class Snapshot {
 public:
  /// Content of a snapshot, for the library itself.
  struct Content;
  explicit Snapshot(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace stepwire
