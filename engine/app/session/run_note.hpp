#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::session {

/// The file run.json of a folder, which is compared with the diagrams of its run.
class RunNote {
 public:
  /// Reads the file. Throws Error for text that is no JSON.
  explicit RunNote(const std::string& folder);

  const json::Json& content() const { return content_; }
  /// Returns the first entry that differs from the flattened diagram in the folder, with its place; empty if
  /// none does, or if the runs of a sweep have diagrams of their own.
  std::string difference_from_folder(const Registry& registry) const;
  /// Returns the first entry that differs from the diagram of the run, loaded again with its values.
  std::string difference_from(const LoadedModel& model) const;
  /// Returns the sentence about ticks where the run has another number of them.
  std::string difference_in_ticks(std::int64_t ticks) const;
  /// Returns the sentence about the hash, where the diagram file has another one.
  std::string other_hash(const std::string& file) const;
  /// Returns step, stop, solver and tolerance of the run, which a call may have set.
  static std::vector<diagram::Setting> head_settings(const std::string& folder, const Registry& registry);

 private:
  std::string difference(const json::Json& computed, const std::string& by) const;
  std::string difference_in_list(const std::string& key, const json::Json& there, const json::Json& computed,
                                 const std::string& by) const;
  /// Returns the file with the line that begins with a text, behind the line of `after`.
  std::string place(const std::string& begin, const std::string& after = "") const;

  std::string folder_, path_, text_;
  json::Json content_;
};

}  // namespace stepwire::session
