#include "engine/app/studio/http/security_headers.hpp"

namespace stepwire::http {

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
