#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/app/session/loop_settings.hpp"
#include "engine/app/studio/http/http_server.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::studio {

struct StudioCall {
  std::string file;
  std::uint16_t port = 0;                       ///< any free one
  std::optional<session::LoopSettings> loop{};  ///< runs are real-time loops
  std::string out{};                            ///< folder for runs that are kept
  http::Limits limits{};
};

/// A diagram file on a page: serves it from its construction to its end, in threads of its own.
class Studio {
 public:
  /// Throws EnvironmentError where the file or the port is not to be had.
  Studio(const StudioCall& call, const Registry& registry);
  /// Keeps all drafts.
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// The address of the page with the token that lets in.
  std::string address() const;

 private:
  class Room;
  std::unique_ptr<Room> room_;
};

}  // namespace stepwire::studio
