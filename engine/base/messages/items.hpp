#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace stepwire::messages {

/// An independent piece of work.
struct Item {
  std::size_t number = 0;  ///< identifies it to the caller
  std::string bytes{};     ///< input of the work
};

/// Function that processes an item and returns its result. Throws Error for an invalid item.
using ItemWork = std::function<std::string(const Item&)>;

/// Processes that work on items of one kind.
class ItemWorkers {
 public:
  virtual ~ItemWorkers() = default;
  /// Returns the results of the items, in their order. Throws EnvironmentError if a process was lost with its
  /// items, ProcessStopped on an interruption, and rethrows the exceptions of the processes.
  virtual std::vector<std::string> run(const std::vector<Item>& items) = 0;
};

}  // namespace stepwire::messages
