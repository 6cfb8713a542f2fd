#pragma once

#include <optional>
#include <string>

#include "engine/base/io/cache.hpp"

namespace stepwire::studio {

/// Where what belongs to a user and not to a diagram is kept: $XDG_STATE_HOME/stepwire/studio, else
/// ~/.local/state/stepwire/studio; empty where there is no such place.
std::string state_folder();

/// A text that was not saved yet.
struct Draft {
  std::string hash;  ///< of the file that it began with
  std::string text;
};

/// What is kept between two starts: drafts of files, and how the page of a file is laid out. Files of the
/// user alone (0600), written whole or not at all, safe on the disk when a call returns.
class DraftStore {
 public:
  explicit DraftStore(const std::string& folder = state_folder());

  std::optional<Draft> find(const std::string& path) const;
  void keep(const std::string& path, const Draft& draft) const;
  void drop(const std::string& path) const;

  /// JSON of the page of a file, or with an empty path of all pages of the user; empty where none was kept.
  std::string layout(const std::string& path) const;
  void keep_layout(const std::string& path, const std::string& layout) const;

 private:
  io::Cache kept_;
};

}  // namespace stepwire::studio
