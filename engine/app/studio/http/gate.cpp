#include "engine/app/studio/http/gate.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <span>
#include <system_error>

namespace stepwire::http {

namespace {

bool is_our_host(const Request& request, const Key& key) {
  const std::string* host = request.header("Host");
  if (!host) return false;
  for (const char* name : {"127.0.0.1", "localhost", "[::1]"})
    if (*host == fmt::format("{}:{}", name, key.port)) return true;
  return false;
}

bool is_our_origin(const Request& request) {
  const std::string* origin = request.header("Origin");
  return origin && *origin == "http://" + *request.header("Host");
}

bool wants_socket(const Request& request) {
  const std::string* upgrade = request.header("Upgrade");
  return upgrade && same_word(*upgrade, "websocket");
}

bool needs_origin(const Request& request) {
  const bool reads = request.method == "GET" || request.method == "HEAD";
  return !reads || request.has("Upgrade") || request.has("Origin");
}

/// Returns the value of the cookie of this port; "" if the request has none or more than one.
std::string cookie(const Request& request, const Key& key) {
  const std::string* line = request.header("Cookie");
  if (!line) return {};
  const std::string name = cookie_name(key) + "=";
  std::string found;
  int count = 0;
  for (std::string_view rest = *line; !rest.empty();) {
    const std::string_view one = rest.substr(0, rest.find(';'));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    const std::string_view pair = one.substr(std::min(one.find_first_not_of(' '), one.size()));
    if (pair.starts_with(name) && ++count == 1) found = pair.substr(name.size());
  }
  return count == 1 ? found : "";
}

bool is_plain(const std::string& target) {
  return target.starts_with('/') &&
         std::ranges::all_of(target, [](char c) { return c > ' ' && c < '\x7f' && c != '#' && c != '\\'; });
}

}  // namespace

Decision decide(const Request& request, const Key& key) {
  if (!is_our_host(request, key) || !is_plain(request.target)) return {};
  if (needs_origin(request) && !is_our_origin(request)) return {};
  const std::string_view target = request.target;
  constexpr std::string_view entrance = "/?token=";
  if (request.method == "GET" && !request.has("Upgrade") && target.starts_with(entrance))
    return same_secret(target.substr(entrance.size()), key.token) ? Decision{Decision::Kind::enter, "/"}
                                                                  : Decision{};
  if (!same_secret(cookie(request, key), key.token)) return {};
  const std::string path(target.substr(0, target.find('?')));
  return {wants_socket(request) ? Decision::Kind::upgrade : Decision::Kind::pass, path};
}

std::string cookie_name(const Key& key) {
  return fmt::format("stepwire-{}", key.port);
}

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "random numbers of the system");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

bool same_secret(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() && !b.empty() ? 0 : 1;
  for (std::size_t i = 0; i < b.size(); ++i)
    difference |=
        static_cast<unsigned char>(a.empty() ? 0 : a[i % a.size()]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

}  // namespace stepwire::http
