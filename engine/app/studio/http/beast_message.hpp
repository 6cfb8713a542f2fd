#pragma once

#include <string>
#include <string_view>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

// Conversions between requests, answers and the types of Beast. They are templates so that no header includes
// Beast.

template <class BeastRequest>
Request request_of(const BeastRequest& from) {
  const auto text = [](const auto& part) { return std::string(part.data(), part.size()); };
  Request request{text(from.method_string()), text(from.target()), {}};
  for (const auto& field : from) request.headers.push_back({text(field.name_string()), text(field.value())});
  return request;
}

/// Returns a response that refers to the body of the answer, which must outlive it. A response to HEAD has no
/// body.
template <class BeastResponse>
BeastResponse response_of(const Answer& answer, bool head, bool keep) {
  const std::string_view body = answer.body.empty() ? answer.fixed : std::string_view(answer.body);
  BeastResponse response;
  response.result(static_cast<unsigned>(answer.status));
  for (const Header& one : answer.headers) response.set(one.name, one.value);
  response.keep_alive(keep);
  response.content_length(body.size());
  if (!head) response.body() = {body.data(), body.size()};
  return response;
}

}  // namespace stepwire::http
