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
  std::uint16_t port = 0;                       ///< 0: any free port
  std::optional<session::LoopSettings> loop{};  ///< set: runs are real-time loops
  std::string out{};                            ///< folder for stored runs
  http::Limits limits{};
};

/// Server of the page of a diagram file. It serves from construction to destruction, in threads of its own.
class Studio {
 public:
  /// Throws EnvironmentError if the file or the port is not available.
  Studio(const StudioCall& call, const Registry& registry);
  /// Stores all drafts.
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// Returns the URL of the page, with its access token.
  std::string address() const;

 private:
  class Room;
  std::unique_ptr<Room> room_;
};

}  // namespace stepwire::studio
