#include "engine/app/language/file_uri.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <filesystem>
#include <string_view>

namespace stepwire::language {

namespace {

constexpr std::string_view scheme = "file://";

std::string decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* const digits = text.data() + i + 1;
    const bool escape = text[i] == '%' && i + 2 < text.size() &&
                        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    result += escape ? static_cast<char>(byte) : text[i];
    i += escape ? 2 : 0;
  }
  return result;
}

}  // namespace

std::string path_of_uri(const std::string& uri) {
  if (!uri.starts_with(scheme)) return uri;
  const std::size_t path = uri.find('/', scheme.size());  // after the host name, which is ignored
  if (path == std::string::npos) return uri;
  return std::filesystem::path(decoded(std::string_view(uri).substr(path))).lexically_normal().string();
}

std::string uri_of_path(const std::string& path) {
  if (!path.starts_with('/')) return path;
  std::string uri(scheme);
  for (const char c : path) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) ||
                       std::string_view("/-._~").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string FileUris::path(const std::string& uri) {
  std::string path = path_of_(uri);
  if (!path.empty()) uris_[path] = uri;
  return path;
}

std::string FileUris::uri(const std::string& path) const {
  const auto known = uris_.find(path);
  return known == uris_.end() ? uri_of_(path) : known->second;
}

}  // namespace stepwire::language
