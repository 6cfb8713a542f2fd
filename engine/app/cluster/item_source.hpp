#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "engine/base/messages/items.hpp"

namespace stepwire::cluster {

/// Queue of items for other processes, and sink of their results. Not thread-safe.
class ItemSource {
 public:
  virtual ~ItemSource() = default;
  /// Returns the next item that is not given out yet; std::nullopt after the last one.
  virtual std::optional<messages::Item> next() = 0;
  /// Returns an upper limit of the number of items that next() will still return.
  virtual std::size_t left() const = 0;
  /// Stores the result of an item. Throws EnvironmentError.
  virtual void take(std::size_t number, std::string_view bytes) = 0;
  /// Returns the finished fraction, 0 to 1, for a progress display.
  virtual double done() const = 0;
};

}  // namespace stepwire::cluster
