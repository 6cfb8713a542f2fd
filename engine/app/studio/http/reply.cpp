#include "engine/app/studio/http/reply.hpp"

#include <fmt/format.h>

#include "engine/app/studio/http/security_headers.hpp"

namespace stepwire::http {

namespace {

/// Sets the cookie and redirects to the page. The token must not stay in the URL, as the browser's history
/// keeps it.
Answer entrance(const Key& key) {
  Answer answer = empty_answer(303);
  answer.headers.push_back({"Location", "/"});
  answer.headers.push_back(
      {"Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name(key), key.token)});
  return answer;
}

}  // namespace

Answer empty_answer(int status) {
  return {status, security_headers(random_token())};
}

Answer reply(const Request& request, const Decision& decision, const Key& key, Site& site) {
  if (decision.kind == Decision::Kind::enter) return entrance(key);
  if (decision.kind != Decision::Kind::pass) return empty_answer(403);
  const bool reads = request.method == "GET" || request.method == "HEAD";
  return reads ? site.answer(request, decision.path) : empty_answer(405);
}

}  // namespace stepwire::http
