#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepwire::http {

struct Header {
  std::string name, value;
};

/// The head of a request of HTTP/1.1 as it came. No request of a page has a body.
struct Request {
  std::string method, target;
  std::vector<Header> headers;

  /// The value of a header, whose name is compared without regard to case; nullptr where there is none or
  /// more than one.
  const std::string* header(std::string_view name) const;
  bool has(std::string_view name) const;
};

/// What is sent back. The bytes must outlive the server where they are not its own.
struct Answer {
  int status = 200;
  std::vector<Header> headers{};
  std::string body{};
  std::string_view fixed{};  ///< a body that is compiled in; sent where `body` is empty
};

/// Are two words of a header the same, without regard to case (ASCII)?
bool same_word(std::string_view a, std::string_view b);

}  // namespace stepwire::http
