#pragma once

#include <cstdint>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::http {

/// Pair of listening sockets on the loopback addresses.
struct Loopback {
  std::uint16_t port = 0;
  io::Descriptor v4;  ///< 127.0.0.1
  io::Descriptor v6;  ///< ::1; closed on a machine without IPv6
};

/// Listens at the same port of both addresses; 0 means any port that is free at both. Throws EnvironmentError
/// with the system's reason.
Loopback listen_on_loopback(std::uint16_t port);

}  // namespace stepwire::http
