#pragma once

#include <map>
#include <string>

namespace stepwire::language {

/// The absolute path that a file URI names; what is no file URI is itself.
std::string path_of_uri(const std::string& uri);
std::string uri_of_path(const std::string& path);

/// Files by the URI that an editor has for each, since editors write the same path in several ways.
class FileUris {
 public:
  std::string path(const std::string& uri);
  std::string uri(const std::string& path) const;

 private:
  std::map<std::string, std::string> uris_;  ///< by path
};

}  // namespace stepwire::language
