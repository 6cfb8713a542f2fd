#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace stepwire::language {

/// The absolute path that a file URI names; what is no file URI is itself.
std::string path_of_uri(const std::string& uri);
std::string uri_of_path(const std::string& path);

/// Files by the URI that an editor has for each, since editors write the same path in several ways.
class FileUris {
 public:
  using Turn = std::function<std::string(const std::string&)>;
  /// URIs of files, or others, which a page has for files whose paths it need not know. What is none gives an
  /// empty path.
  explicit FileUris(Turn path_of = path_of_uri, Turn uri_of = uri_of_path)
      : path_of_(std::move(path_of)), uri_of_(std::move(uri_of)) {}

  std::string path(const std::string& uri);
  std::string uri(const std::string& path) const;

 private:
  Turn path_of_, uri_of_;
  std::map<std::string, std::string> uris_;  ///< by path
};

}  // namespace stepwire::language
