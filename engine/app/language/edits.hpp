#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/app/language/renaming.hpp"
#include "engine/app/language/tree_edits.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::language {

// Edits of a diagram, as made in its drawing. Names are those within the file.

/// New value, a number, word or expression: of a block or part ("spring.gain", element "spring.gain.2"), of
/// the file ("mass"), or of its head ("stop"). A missing key is added.
struct SetValue {
  std::string name, text;
};
/// New number, word or expression at an offset.
struct SetValueAt {
  std::size_t offset;  ///< [bytes]
  std::string text;
};
/// New name of a block, part, parameter or port of the file, with all uses.
struct Rename {
  std::string name, to;
};
/// Wire from a signal to an input of a block or part ("u", of a list "u.2"). With an empty block the input is
/// an output of the file.
struct Connect {
  std::string from, to, input;
};
struct Disconnect {
  std::string to, input;
};
/// Removal of a block, part or parameter, and of its names from lists of recorded or drawn signals.
struct Remove {
  std::string name;
};
/// New block of a type, or new part by its file name relative to the diagram. An empty name is generated.
struct Insert {
  std::string type, name;
  std::vector<std::pair<std::string, std::string>>
      inputs{};  ///< inputs with their source signals; "u.2" for lists
};

/// New item of a section that is a list or may be one: "figure", "claims".
struct AddItem {
  std::string section, text;
};
/// New linear analysis of the loop that is opened at a signal, with the figure of its Bode plot.
struct CutLoop {
  std::string signal;
  std::string at{};  ///< time of the operating point, "0.5 s"; empty: the start
};

using Edit =
    std::variant<SetValue, SetValueAt, Rename, Connect, Disconnect, Remove, Insert, AddItem, CutLoop>;

/// Result of an edit.
struct Edited {
  FileSplices changes;
  std::string name{};                 ///< name of the added block or item
  std::vector<yaml::Fault> faults{};  ///< new faults of the changed files
};

/// Computes the splices of an edit. The rest of the files is unchanged, which is verified by parsing the
/// result.
/// Throws EditRefused with a sentence: for unknown names, invalid values, wires with different units, and
/// texts in which the splices would affect other values.
Edited edited(DiagramFiles& files, const std::string& file, const Edit& edit);

/// Input of a block or part, or with an empty block an output of the file.
struct InputName {
  std::string block, input;

  bool operator==(const InputName&) const = default;
};

/// Returns the inputs to which a signal may be connected, that is, where the edit would not be refused.
std::vector<InputName> inputs_for(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                  const std::string& from);
/// Throws EditRefused for a wire between two known, different units.
void check_units(DiagramFiles& files, const Analysis& analysis, const std::string& file, const Connect& edit);

/// Adds an analysis to `linear` and its Bode plot to `figure`, and returns the name of the analysis.
std::string cut_loop(TreeEdits& edits, const yaml::Document& document, const CutLoop& edit);

/// Parses an edit from a page, by its `kind`.
/// Values: {kind: number, name | at, text}. Names: {kind: rename, name, to}.
/// Wires: {kind: connect, from, to, input}, {kind: disconnect, to, input}.
/// Blocks: {kind: delete, name}, {kind: insert, type, name?}.
/// Throws EditRefused for anything else.
Edit edit_of(const json::Json& edit);

}  // namespace stepwire::language
