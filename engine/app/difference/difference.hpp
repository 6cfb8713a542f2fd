#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/app/difference/facts.hpp"
#include "engine/base/result/record.hpp"

namespace stepwire::difference {

/// One difference in the meaning of two files.
struct Change {
  enum class Kind { added, removed, renamed, moved, changed };
  Kind kind = Kind::changed;
  std::string section;            ///< Blocks, wires, values, head, or a section of the file.
  std::string name;               ///< "spring.gain"; of a claim its sentence.
  std::string from{};             ///< As written in the old file; empty for an added one.
  std::string to{};               ///< As written in the new file; empty for a removed one.
  std::optional<double> ratio{};  ///< New number over old number of the same unit.
  yaml::Mark before{};            ///< Place in the old file; line 0 without one.
  yaml::Mark after{};             ///< Place in the new file; line 0 without one.
};

/// Differences of one file, in the order of its sections.
struct FileDifference {
  std::string before, after;  ///< the two files
  std::vector<Change> changes;
  std::string before_name{}, after_name{};  ///< of fetched files "rig/plain.yaml at 2f0c7c5"; else empty
};

/// Differences of two diagrams and of the parts that both use. Files without differences are left out.
struct Difference {
  std::vector<FileDifference> files;

  bool is_empty() const { return files.empty(); }
};

void declare(result::Record<Difference>& is);

/// Compares the meaning of two diagram files and of their parts. Throws yaml::Error for an unreadable file.
class Comparer {
 public:
  Comparer(const Registry& registry, Texts& before, Texts& after)
      : before_texts_(before), after_texts_(after), before_(registry, before), after_(registry, after) {}

  /// Adds the differences of two files. With `parts` the parts that both use are compared, too, at every
  /// depth. A pair of files is compared once. A part that cannot be read is a fault of result().
  void compare(const std::string& before, const std::string& after, bool parts = true);
  /// Returns all differences. Throws yaml::Error for parts that cannot be read.
  const Difference& result() const;

 private:
  class OfFiles;

  Texts &before_texts_, &after_texts_;
  FactReader before_, after_;
  /// Adds a fault for each part that a file uses and that cannot be read.
  void check_parts(const FileFacts& user, Texts& texts);
  /// Returns the name of a fetched file with its short commit; empty for others.
  std::string fetched_name(const std::string& file) const;

  std::set<std::pair<std::string, std::string>> done_;
  std::map<std::string, std::string> uses_;  ///< names of fetched folders
  Difference result_;
  std::vector<yaml::Fault> faults_;
};

/// Returns the word of a kind: "added".
const char* word_of(Change::Kind kind);

}  // namespace stepwire::difference
