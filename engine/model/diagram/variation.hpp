#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/bindings.hpp"

namespace stepwire::diagram {

/// A value for a parameter ("rig.mass"), a value of a block ("spring.gain"), an initial value ("lag.initial")
/// or a constant that is wired to an input ("sum.u.2", "lag.u").
struct Assignment {
  std::string name;
  yaml::Node value;   ///< as a file writes it: 8 kg, [1, 2], a word
  std::string place;  ///< what messages name as its place
};

/// The name under which a value of a block is set.
std::string name_of(const Diagram& diagram, const Target& target);

/// The value of an assignment from its text, as `--set` reads it. Throws Error for what is not YAML.
yaml::Node value_of_text(const std::string& text, const std::string& place);
/// A number in SI, of a dimension where it has one.
yaml::Node value_of_number(double number, const std::optional<unit::Dimension>& dimension);

/// What changes in a diagram when values of some names change together. Follows from the texts of the
/// diagram's files alone, whatever the values are.
class Variation {
 public:
  /// What one of the names is.
  struct Name {
    std::string text;
    int definition = -1;  ///< of a parameter; else `target`
    Target target;
    bool structural =
        false;  ///< the diagram itself is another one for each value: its times, what it records
  };

  /// The diagram must outlive it. Throws Error for a name that nothing has.
  Variation(const Diagram& diagram, const std::vector<std::string>& names);

  const std::vector<Name>& names() const { return names_; }
  /// Is the diagram itself another one for each value of one of the names?
  bool structural() const;
  /// Parameters that follow from those that are set, in the order in which they are evaluated.
  const std::vector<int>& definitions() const { return definitions_; }
  /// Values of blocks that follow from parameters, by their index in Bindings::bindings.
  const std::vector<int>& bindings() const { return bindings_; }
  /// All values of blocks that may change.
  const std::vector<Target>& targets() const { return targets_; }

 private:
  Name find(const Diagram& diagram, const std::string& text) const;
  /// Is another parameter that follows from this name, or itself, what the diagram is made of?
  static bool decides(const Diagram& diagram, int definition);
  void follow(const Diagram& diagram);

  std::vector<Name> names_;
  std::vector<int> definitions_, bindings_;
  std::vector<Target> targets_;
};

}  // namespace stepwire::diagram
