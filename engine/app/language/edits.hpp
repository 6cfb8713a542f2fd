#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/app/language/renaming.hpp"

namespace stepwire::language {

// Changes of a diagram, as a person makes them in its drawing. Names are those of the file itself.

/// A number, word or expression: of a parameter of a block or part ("spring.gain", an element of it
/// "spring.gain.2"), of the file ("mass"), or of its head ("stop"). What was left to its default is added.
struct SetValue {
  std::string name, text;
};
/// A number, word or expression that stands at a place of the text.
struct SetValueAt {
  std::size_t offset;  ///< [bytes]
  std::string text;
};
/// A block, part, parameter or port of the file, with every use of it.
struct Rename {
  std::string name, to;
};
/// Feeds an input of a block or part ("u", of a list "u.2"), or with no block an output of the file.
struct Connect {
  std::string from, to, input;
};
struct Disconnect {
  std::string to, input;
};
/// A block, part or parameter; out of lists of what is recorded or drawn its names go, too.
struct Remove {
  std::string name;
};
/// A kind of block, or the file of a part as the diagram would name it. Without a name one is made.
struct Insert {
  std::string type, name;
  std::vector<std::pair<std::string, std::string>>
      inputs{};  ///< with the signals that feed them; "u.2" of lists
};

/// One more item of a section that is a list or may be one: "figure", "claims".
struct AddItem {
  std::string section, text;
};
/// A linear analysis of the loop through a signal, cut there, and the figure of its Bode plot.
struct CutLoop {
  std::string signal;
  std::string at{};  ///< the time of the working point, "0.5 s"; "" for the start
};

using Edit =
    std::variant<SetValue, SetValueAt, Rename, Connect, Disconnect, Remove, Insert, AddItem, CutLoop>;

/// What an edit comes to.
struct Edited {
  FileSplices changes;
  std::string name{};                 ///< of what was inserted or added
  std::vector<yaml::Fault> faults{};  ///< that the changed files have now, and did not have before
};

/// The splices of an edit: all else of the files stays as it is, which is checked by reading them again.
/// Throws EditRefused, with a sentence, for names that mean nothing, values that are none, wires whose units
/// do not fit, and texts in which the change would touch anything else.
Edited edited(DiagramFiles& files, const std::string& file, const Edit& edit);

/// An input of a block, part, or of the file's outputs (with no block).
struct InputName {
  std::string block, input;

  bool operator==(const InputName&) const = default;
};

/// The inputs of a file to which a signal may be connected: all for which the edit would not be refused.
std::vector<InputName> inputs_for(DiagramFiles& files, const Analysis& analysis, const std::string& file,
                                  const std::string& from);
/// Throws EditRefused for a wire between two units that are known and are not the same.
void check_units(DiagramFiles& files, const Analysis& analysis, const std::string& file, const Connect& edit);

}  // namespace stepwire::language
