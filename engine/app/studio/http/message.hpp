#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepwire::http {

struct Header {
  std::string name, value;
};

/// Head of an HTTP/1.1 request as received. Requests of a page have no body.
struct Request {
  std::string method, target;
  std::vector<Header> headers;

  /// Returns the value of a header; its name is case-insensitive. nullptr if the header is missing or
  /// repeated.
  const std::string* header(std::string_view name) const;
  bool has(std::string_view name) const;
};

/// Response to a request. `fixed` must outlive the server.
struct Answer {
  int status = 200;
  std::vector<Header> headers{};
  std::string body{};
  std::string_view fixed{};  ///< body that is compiled in; used if `body` is empty
};

/// True if two words are equal without regard to case (ASCII).
bool same_word(std::string_view a, std::string_view b);

/// Returns the headers of every answer: no caching, no framing, no resources from other origins. Styles must
/// come from this origin or carry the nonce.
std::vector<Header> security_headers(const std::string& nonce);

}  // namespace stepwire::http
