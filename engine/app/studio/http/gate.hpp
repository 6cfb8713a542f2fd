#pragma once

#include <cstdint>
#include <string>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// Credentials of the server.
struct Key {
  std::uint16_t port = 0;
  std::string token;  ///< 32 hexadecimal digits
};

/// Verdict of the gate on a request.
struct Decision {
  enum class Kind {
    refuse,   ///< 403 without a body
    enter,    ///< the URL had the token: sets the cookie and redirects to the page without it
    pass,     ///< serves `path`
    upgrade,  ///< opens a socket at `path`
  };
  Kind kind = Kind::refuse;
  std::string path{};  ///< as sent, without decoding

  bool operator==(const Decision&) const = default;
};

/// Decides on a request, of a page or of a socket. Host must be a loopback name with the port. Origin must be
/// that host if it is sent; sockets and methods other than GET and HEAD require it. The token must be in the
/// cookie, or once in the URL of the page.
Decision decide(const Request& request, const Key& key);

/// Returns "stepwire-8080": the port is in the name because browsers share the cookies of all ports of a
/// host.
std::string cookie_name(const Key& key);

/// Returns 128 bits of the system's random numbers as hexadecimal digits.
std::string random_token();

/// Compares two texts in constant time.
bool same_secret(std::string_view a, std::string_view b);

}  // namespace stepwire::http
