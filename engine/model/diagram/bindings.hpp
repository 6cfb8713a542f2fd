#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// Text of a value in a file, and the scope for reading it: with other parameters the same text has another
/// value.
struct ValueText {
  yaml::Node node;
  int names = 0;  ///< index in Diagram::scopes of the file whose parameters it names
  int place = 0;  ///< index of the scope that contains it, which may be a setting
};

/// Definition of a parameter.
struct Definition {
  std::string name;  ///< within its file
  int scope = 0;     ///< index of its file in Diagram::scopes
  ValueText text;
  std::vector<yaml::Entry>
      bounds;  ///< `above`, `at_least`, `below`, `at_most`, read with the parameters of its file
  std::optional<unit::Dimension> dimension;  ///< of the file's own value; all other values must have it
  ParameterUses uses;
  EachUnit each{};  ///< units of its elements in several; `dimension` is then nullopt
};

/// Owner of a value.
struct Target {
  enum class Kind {
    parameter,  ///< `index` is that in the type's parameters
    initial,    ///< `index` is that in the type's states
    constant    ///< `index` is that in the type's inputs, `element` that among its sources
  };
  Kind kind = Kind::parameter;
  int block = -1;
  int index = -1, element = 0;

  bool operator==(const Target&) const = default;
};

/// A value of a block that depends on parameters.
struct Binding {
  Target target;
  ValueText text;
  ParameterUses uses;
};

/// Texts of all values of a diagram that are evaluated again when a parameter changes.
struct Bindings {
  std::vector<ParameterScope> scopes;   ///< one for each of Diagram::scopes, with its values
  std::vector<Definition> definitions;  ///< parallel to Diagram::parameters: each follows those that it uses
  std::vector<Binding> bindings;
};

/// Keys of bounds in a definition, as in `{value: 2 kg, above: 0}`.
extern const std::vector<std::string> bound_keys;

/// Records the origin of a text that replaces a definition's own value. It is needed for faults, since a use
/// that requires a number may refuse the text later.
void note_giver(WrittenValue& value, const Definition& definition, const std::string& full_name,
                const Origin& origin);

/// Checks a parameter's value, written at `origin`, against unit and bounds of its definition; `uses`
/// collects the parameters that bounds name. Adds a fault and returns false if a bound is violated. A wrong
/// unit is a fault as well, but the value is kept with the right unit.
bool accepts(const Definition& definition, const ParameterScope& scope, WrittenValue& value,
             const Origin& origin, const std::string& full_name, ParameterUses& uses, FaultReport& report);

}  // namespace stepwire::diagram
