#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "engine/base/messages/items.hpp"

namespace stepwire::cluster {

/// Items that other processes are to do, and where goes what comes out of them. One thread at a time.
class ItemSource {
 public:
  virtual ~ItemSource() = default;
  /// One that no process has been given yet; nothing once there is none.
  virtual std::optional<messages::Item> next() = 0;
  /// Those that next() has not named yet, at most.
  virtual std::size_t left() const = 0;
  /// What a process sent of an item that it has done. Throws EnvironmentError.
  virtual void take(std::size_t number, std::string_view bytes) = 0;
  /// How much is done, 0 to 1, for people.
  virtual double done() const = 0;
};

}  // namespace stepwire::cluster
