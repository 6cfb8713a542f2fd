#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Returns a text of a diagram as a part of a C++ comment. It is on one line, without anything that ends the
/// comment or continues it on the next line.
std::string cpp_comment(std::string_view text);

/// Returns the C++ identifier of a name in a diagram or file: "rig.carriage" gives rig_carriage. Programs
/// append another word, so the result cannot be a keyword or a name of a library.
std::string cpp_identifier(std::string_view name);

/// Returns the same as a member of a struct, "rig_carriage_", with a number appended if that name is taken.
std::string free_member(std::string_view name, std::set<std::string>& taken);

/// Returns a C++ string literal with exactly the bytes of a text.
std::string cpp_string(std::string_view text);

/// Place of the workspace with its name in the program.
struct NamedPlace {
  std::size_t offset;
  Index size;
  std::string name;     ///< "rig_carriage_position"
  std::string meaning;  ///< "rig.carriage.position, Mass, platform-1d.yaml:31", as part of a comment
};

/// Names of the workspace's numbers in generated code.
class PlaceNames {
 public:
  explicit PlaceNames(const plan::Plan& plan);

  const std::vector<NamedPlace>& places() const { return places_; }
  /// Returns "at::rig_carriage_position".
  std::string at(std::size_t offset) const;
  /// Returns "rig_carriage".
  const std::string& block(std::size_t block) const { return blocks_[block]; }

 private:
  void add(const plan::Plan& plan, std::size_t block, const std::string& member,
           const plan::SignalSlot& slot);
  void add_block(const plan::Plan& plan, std::size_t block);
  void add_constants(const plan::Plan& plan, std::size_t block);

  std::string free(const std::string& name);

  std::vector<std::string> blocks_;
  std::vector<NamedPlace> places_;
  std::map<std::size_t, std::size_t> by_offset_;
  std::set<std::string> taken_;
};

/// Returns "carriage: Mass, platform-1d.yaml:31", as part of a comment.
std::string comment_of(const plan::Plan& plan, std::size_t block);

}  // namespace stepwire::codegen
