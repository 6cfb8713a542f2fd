#include "engine/app/studio/page_site.hpp"

#include <algorithm>
#include <map>

#include "engine/app/studio/http/gate.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {
namespace {

constexpr const char* no_page =
    "<!doctype html><meta charset=utf-8><title>Stepwire</title><p>The program was built without its page. "
    "./stepwire setup in its checkout builds it, and says why where it cannot.";

bool takes_packed(const http::Request& request) {
  const std::string* accepted = request.header("Accept-Encoding");
  return accepted && accepted->find("gzip") != std::string::npos;
}

}  // namespace

http::Answer page_answer(std::span<const PageFile> table, const http::Request& request,
                         const std::string& path) {
  const std::string nonce = http::random_token();
  http::Answer answer{200, http::security_headers(nonce)};
  const std::string_view wanted = path == "/" ? std::string_view("/index.html") : std::string_view(path);
  const auto file = std::ranges::find(table, wanted, &PageFile::path);
  if (file == table.end() && path == "/") {
    answer.headers.push_back({"Content-Type", content_type("x.html")});
    answer.body = no_page;
  } else if (file == table.end()) {
    answer.status = 404;
  } else if (answer.headers.push_back({"Content-Type", content_type(wanted)}); wanted.ends_with(".html")) {
    answer.body = file->bytes;
    text::replace_all(answer.body, std::string(nonce_mark), nonce);
  } else if (takes_packed(request) && !file->packed.empty()) {
    answer.headers.push_back({"Content-Encoding", "gzip"});
    answer.fixed = file->packed;
  } else {
    answer.fixed = file->bytes;
  }
  return answer;
}

std::string content_type(std::string_view path) {
  static const std::map<std::string_view, const char*> types{
      {"html", "text/html; charset=utf-8"},
      {"js", "text/javascript; charset=utf-8"},
      {"mjs", "text/javascript; charset=utf-8"},
      {"css", "text/css; charset=utf-8"},
      {"svg", "image/svg+xml"},
      {"png", "image/png"},
      {"json", "application/json"},
      {"txt", "text/plain; charset=utf-8"},
      {"woff2", "font/woff2"},
      {"wasm", "application/wasm"},
  };
  const auto found = types.find(path.substr(path.rfind('.') + 1));
  return found == types.end() ? "application/octet-stream" : found->second;
}

}  // namespace stepwire::studio
