#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// A text of a file that has a value, and where it is read: the same text with other parameters has another
/// value.
struct ValueText {
  yaml::Node node;
  int names = 0;  ///< index in Diagram::scopes of the file whose parameters it names
  int place = 0;  ///< and of where it stands, which may be a setting
};

/// How a parameter is defined.
struct Definition {
  std::string name;  ///< in its file
  int scope = 0;     ///< of that file, in Diagram::scopes
  ValueText text;
  std::vector<yaml::Entry>
      bounds;  ///< `above`, `at_least`, `below`, `at_most`, read with its file's parameters
  std::optional<unit::Dimension> dimension;  ///< of the file's own value, which every other one has
  ParameterUses uses;
};

/// What a value belongs to.
struct Target {
  enum class Kind {
    parameter,  ///< `index` in the type's parameters
    initial,    ///< `index` in the type's states
    constant    ///< `index` in the type's inputs, `element` in what is wired to it
  };
  Kind kind = Kind::parameter;
  int block = -1;
  int index = -1, element = 0;

  bool operator==(const Target&) const = default;
};

/// A value of a block that follows from parameters.
struct Binding {
  Target target;
  ValueText text;
  ParameterUses uses;
};

/// Where the numbers of a diagram come from: the texts that are evaluated again when a parameter changes.
struct Bindings {
  std::vector<ParameterScope> scopes;   ///< of each of Diagram::scopes, with its values
  std::vector<Definition> definitions;  ///< parallel to Diagram::parameters: each after those that it uses
  std::vector<Binding> bindings;
};

/// The bounds that a definition may have, as `{value: 2 kg, above: 0}`.
extern const std::vector<std::string> bound_keys;

/// Notes who gives a value in the place of a definition's own, where it is a text: this may be refused later,
/// by what needs a number.
void note_giver(WrittenValue& value, const Definition& definition, const std::string& full_name,
                const Origin& origin);

/// Checks a parameter's value, which stands at `origin`, against the unit and the bounds of its definition;
/// `uses` gathers the parameters that bounds name. False, and a fault, where a bound refuses it; a unit that
/// is not the definition's is a fault, too, and the value goes on with the right one.
bool accepts(const Definition& definition, const ParameterScope& scope, WrittenValue& value,
             const Origin& origin, const std::string& full_name, ParameterUses& uses, FaultReport& report);

}  // namespace stepwire::diagram
