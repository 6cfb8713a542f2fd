#include "engine/app/studio/http/message.hpp"

#include <algorithm>

namespace stepwire::http {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower, lower);
}

const std::string* Request::header(std::string_view name) const {
  const std::string* found = nullptr;
  for (const Header& one : headers) {
    if (!same_word(one.name, name)) continue;
    if (found) return nullptr;
    found = &one.value;
  }
  return found;
}

bool Request::has(std::string_view name) const {
  return std::ranges::any_of(headers, [&](const Header& one) { return same_word(one.name, name); });
}

std::vector<Header> security_headers(const std::string& nonce) {
  return {
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; worker-src 'self'; connect-src 'self'; img-src 'self' data: "
       "blob:; style-src 'self' 'nonce-" +
           nonce + "'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'"},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cache-Control", "no-store"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Embedder-Policy", "require-corp"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
  };
}

}  // namespace stepwire::http
