#pragma once

#include <memory>
#include <utility>

namespace stepwire {

/// A moment of a run, to return to as often as needed; copies share it. It holds all that moves, but not the
/// parameters, which stay as they are set when a run returns.
class Snapshot {
 public:
  /// What it holds; for the library itself.
  struct Content;
  explicit Snapshot(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  const Content& content() const { return *content_; }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace stepwire
