#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/bindings.hpp"

namespace stepwire::diagram {

/// New value of a parameter ("rig.mass"), of a block ("spring.gain"), of an initial value ("lag.initial") or
/// of a constant wired to an input ("sum.u.2", "lag.u").
struct Assignment {
  std::string name;
  yaml::Node value;   ///< as in a file: 8 kg, [1, 2], a word
  std::string place;  ///< its location in messages
};

/// Returns the name by which a value of a block is set.
std::string name_of(const Diagram& diagram, const Target& target);

/// Parses the value of an assignment as `--set` does. Throws Error for invalid YAML.
yaml::Node value_of_text(const std::string& text, const std::string& place);
/// Makes a value of a number in SI with an optional dimension.
yaml::Node value_of_number(double number, const std::optional<unit::Dimension>& dimension);

/// Set of changes in a diagram when the values of some names change together. It depends only on the texts of
/// the diagram's files, not on the values.
class Variation {
 public:
  /// Meaning of one of the names.
  struct Name {
    std::string text;
    int definition = -1;  ///< index of a parameter; otherwise `target` applies
    Target target;
    bool structural = false;  ///< each value needs a diagram of its own: times, recorded signals
  };

  /// The diagram must outlive it. Throws Error for an unknown name.
  Variation(const Diagram& diagram, const std::vector<std::string>& names);

  const std::vector<Name>& names() const { return names_; }
  /// True where a value of one of the names needs a diagram of its own.
  bool structural() const;
  /// Returns the parameters that depend on the set ones, in the order of their evaluation.
  const std::vector<int>& definitions() const { return definitions_; }
  /// Returns the values of blocks that depend on parameters, as indices in Bindings::bindings.
  const std::vector<int>& bindings() const { return bindings_; }
  /// Returns all values of blocks that may change.
  const std::vector<Target>& targets() const { return targets_; }

 private:
  Name find(const Diagram& diagram, const std::string& text) const;
  /// True where this parameter, or one that depends on it, determines the structure of the diagram.
  static bool decides(const Diagram& diagram, int definition);
  void follow(const Diagram& diagram);

  std::vector<Name> names_;
  std::vector<int> definitions_, bindings_;
  std::vector<Target> targets_;
};

}  // namespace stepwire::diagram
