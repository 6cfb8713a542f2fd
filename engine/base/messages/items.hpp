#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace stepwire::messages {

/// A piece of work that hangs on no other one.
struct Item {
  std::size_t number = 0;  ///< by which the call knows it again
  std::string bytes{};     ///< what the work is done with
};

/// Does an item, and gives what came out of it. Throws Error where the item is refused.
using ItemWork = std::function<std::string(const Item&)>;

/// Other processes that do items of one kind of work.
class ItemWorkers {
 public:
  virtual ~ItemWorkers() = default;
  /// What came out of each item, in their order. Throws EnvironmentError where some were lost with a process,
  /// ProcessStopped where the user interrupted, and what a process threw.
  virtual std::vector<std::string> run(const std::vector<Item>& items) = 0;
};

}  // namespace stepwire::messages
