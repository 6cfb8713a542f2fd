#pragma once

#include <optional>
#include <string>

#include "engine/base/io/cache.hpp"

namespace stepwire::studio {

/// Returns the folder for data of the user: $XDG_STATE_HOME/stepwire/studio, else
/// ~/.local/state/stepwire/studio; "" if neither variable is usable.
std::string state_folder();

/// Edited text that is not saved yet.
struct Draft {
  std::string hash;  ///< hash of the file from which the draft started
  std::string text;
};

/// Persistent store of drafts and page layouts between sessions. Its files are private to the user (0600) and
/// written atomically; they are synced to the disk before a call returns.
class DraftStore {
 public:
  explicit DraftStore(const std::string& folder = state_folder());

  std::optional<Draft> find(const std::string& path) const;
  void keep(const std::string& path, const Draft& draft) const;
  void drop(const std::string& path) const;

  /// Returns the layout of the page of a file as JSON; an empty path means all pages of the user. "" if none
  /// was stored.
  std::string layout(const std::string& path) const;
  void keep_layout(const std::string& path, const std::string& layout) const;

 private:
  io::Cache kept_;
};

}  // namespace stepwire::studio
