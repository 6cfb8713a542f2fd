#include "engine/app/studio/http/loopback.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::http {

namespace {

/// Returns a listening socket; a closed one with errno on failure.
template <class Address>
io::Descriptor listener(const Address& address, int family) {
  io::Descriptor socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int on = 1;
  ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (family == AF_INET6) ::setsockopt(socket.number(), IPPROTO_IPV6, IPV6_V6ONLY, &on, sizeof on);
  const bool listens =
      socket.open() &&
      ::bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(socket.number(), SOMAXCONN) == 0;
  return listens ? std::move(socket) : io::Descriptor();
}

io::Descriptor listen_v4(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return listener(address, AF_INET);
}

io::Descriptor listen_v6(std::uint16_t port) {
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(port);
  address.sin6_addr = in6addr_loopback;
  return listener(address, AF_INET6);
}

std::uint16_t port_of(const io::Descriptor& socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

/// Returns std::nullopt if the port is taken at one of the addresses.
std::optional<Loopback> try_port(std::uint16_t port) {
  Loopback both{port, listen_v4(port), {}};
  if (!both.v4.open() && errno == EADDRINUSE) return std::nullopt;
  if (!both.v4.open())
    throw io::EnvironmentError(fmt::format("port {}: {}", port, std::generic_category().message(errno)));
  both.port = port_of(both.v4);
  both.v6 = listen_v6(both.port);
  if (!both.v6.open() && errno == EADDRINUSE) return std::nullopt;
  return both;
}

}  // namespace

Loopback listen_on_loopback(std::uint16_t port) {
  for (int attempt = 0; attempt < (port == 0 ? 16 : 1); ++attempt)
    if (auto both = try_port(port)) return *std::move(both);
  throw io::EnvironmentError(
      fmt::format("port {} is taken on this machine; --port N names another one", port));
}

}  // namespace stepwire::http
