#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace stepwire::language {

/// Returns the absolute path of a file URI; any other text is returned unchanged.
std::string path_of_uri(const std::string& uri);
std::string uri_of_path(const std::string& path);

/// Map from paths to the URIs that the editor uses, since editors encode the same path in several ways.
class FileUris {
 public:
  using Turn = std::function<std::string(const std::string&)>;
  /// Converts file URIs, or URIs of a page that does not know paths. `path_of` returns an empty path for an
  /// invalid URI.
  explicit FileUris(Turn path_of = path_of_uri, Turn uri_of = uri_of_path)
      : path_of_(std::move(path_of)), uri_of_(std::move(uri_of)) {}

  std::string path(const std::string& uri);
  std::string uri(const std::string& path) const;

 private:
  Turn path_of_, uri_of_;
  std::map<std::string, std::string> uris_;  ///< by path
};

}  // namespace stepwire::language
