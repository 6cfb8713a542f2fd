#pragma once

#include <cstdint>
#include <string>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// What a request must know to be let in.
struct Key {
  std::uint16_t port = 0;
  std::string token;  ///< 32 hexadecimal digits
};

/// What becomes of a request.
struct Decision {
  enum class Kind {
    refuse,   ///< 403 without a body
    enter,    ///< the token was in the address: a cookie for it, and to the page without it
    pass,     ///< may have what stands under `path`
    upgrade,  ///< may open a socket at `path`
  };
  Kind kind = Kind::refuse;
  std::string path{};  ///< as it was sent: nothing in it is decoded

  bool operator==(const Decision&) const = default;
};

/// The one gate of pages and sockets. Host has to be a loopback name with the port. Origin, where it is sent
/// and in any case for sockets and for methods other than GET and HEAD, has to be that of this host. The
/// token has to be in the cookie, or once in the address of the page.
Decision decide(const Request& request, const Key& key);

/// "stepwire-8080": browsers keep one jar of cookies for all ports of a host.
std::string cookie_name(const Key& key);

/// 128 bits of the system's random numbers as hexadecimal digits.
std::string random_token();

/// Compares in a time that does not depend on where two texts differ.
bool same_secret(std::string_view a, std::string_view b);

}  // namespace stepwire::http
