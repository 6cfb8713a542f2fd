#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::difference {

/// Names of blocks, parameters and inputs of one file. In canonical texts each of them is between two marks,
/// so that a rename can replace it.
class FileNames {
 public:
  /// Function that returns the name of a block's only output; empty for a block with several.
  using OnlyOutput = std::function<std::string(const yaml::Entry& block)>;

  FileNames(const yaml::Document& document, OnlyOutput only_output);

  /// Returns a signal with its first name marked: "hand.2". With `shorten` the only output of a block is left
  /// out: "hand" for "hand.y".
  std::string signal(std::string_view name, bool shorten) const;
  std::string parameter(std::string_view name) const;
  /// Returns a name of the file, marked where the file has it.
  std::string any(std::string_view name) const;
  bool has_parameter(std::string_view name) const { return parameters_.contains(name); }

 private:
  std::string block(const yaml::Entry& block, std::string_view rest, bool shorten) const;

  std::map<std::string, const yaml::Entry*, std::less<>> blocks_, parameters_, inputs_;
  OnlyOutput only_output_;
};

/// Kinds of names that a rename can change.
enum class NameKind { block, parameter, input, output };

/// New names by kind and old name.
using NewNames = std::map<std::pair<NameKind, std::string>, std::string>;

/// Returns a name between its marks.
std::string marked(NameKind kind, std::string_view name);
/// Returns a canonical text with names replaced.
std::string renamed(const std::string& canonical, const NewNames& names);
/// Returns a canonical text without marks.
std::string unmarked(const std::string& canonical);
/// True where a canonical text without marks is this name.
bool is_unmarked(std::string_view canonical, std::string_view name);
/// Returns the names of a kind in a canonical text.
std::vector<std::string> names_in(const std::string& canonical, NameKind kind);

/// Returns the number in SI with its dimension. `demanded` is the dimension of a fixed unit, which a bare
/// number then has as well.
std::string canonical_number(const unit::Quantity& quantity, const std::optional<unit::Dimension>& demanded);

/// Context in which a text is read.
struct TextReading {
  const FileNames& names;
  std::optional<unit::Dimension> demanded{};
  bool shorten = false;    ///< Leaves out the only output of a block.
  bool literal = false;    ///< The text has no names except after '$'.
  bool formula = false;    ///< Names in it are those of parameters.
  bool in_unit = false;    ///< The text may end in " in mm".
  bool is_signal = false;  ///< A single name is that of a signal.
};

/// Returns a text that is the same for all notations of a number, formula or name.
std::string canonical_text(const std::string& text, const TextReading& reading);

}  // namespace stepwire::difference
