#pragma once

#include <cstdint>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::http {

/// Sockets that listen to this machine alone.
struct Loopback {
  std::uint16_t port = 0;
  io::Descriptor v4;  ///< at 127.0.0.1
  io::Descriptor v6;  ///< at ::1; not open where the machine has no IPv6
};

/// Listens at one port of both addresses; 0 is any that is free at both. Throws EnvironmentError with the
/// system's reason.
Loopback listen_on_loopback(std::uint16_t port);

}  // namespace stepwire::http
