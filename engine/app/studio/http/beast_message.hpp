#pragma once

#include <boost/beast/http.hpp>
#include <string>
#include <string_view>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

// Requests and answers in the types of Beast, for the one source that includes it.

using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
using Response = boost::beast::http::response<boost::beast::http::span_body<const char>>;

inline Request request_of(const Parser& parser) {
  const auto text = [](boost::beast::string_view part) { return std::string(part.data(), part.size()); };
  const auto& from = parser.get();
  Request request{text(from.method_string()), text(from.target()), {}};
  for (const auto& field : from) request.headers.push_back({text(field.name_string()), text(field.value())});
  return request;
}

/// It refers to the body of the answer, which must outlive it; to HEAD it has none.
inline Response response_of(const Answer& answer, bool head, bool keep) {
  const std::string_view body = answer.body.empty() ? answer.fixed : std::string_view(answer.body);
  Response response(boost::beast::http::int_to_status(static_cast<unsigned>(answer.status)), 11);
  for (const Header& one : answer.headers) response.set(one.name, one.value);
  response.keep_alive(keep);
  response.content_length(body.size());
  if (!head) response.body() = {body.data(), body.size()};
  return response;
}

}  // namespace stepwire::http
