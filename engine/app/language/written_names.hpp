#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/language/text_places.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/key.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::language {

/// Alternative forms of a value.
using FormList = std::vector<const yaml::Key*>;

/// Forms of all places in diagram files, from the key tables of their reader and from the declarations of the
/// blocks.
class Forms {
 public:
  explicit Forms(const Registry& registry) : registry_(registry) {}

  /// Returns the form of a whole file.
  FormList root() const;
  /// Returns the forms of the value under a key, for a map with one of the given forms.
  FormList under(const FormList& map_forms, const yaml::Node& map, const std::string& key);
  /// Returns the forms of the items, for a list with one of the given forms.
  FormList items(const FormList& list_forms);
  /// Returns the map forms for a particular map. The keys of a block depend on its type, those of a figure on
  /// its plot.
  FormList maps(const FormList& forms, const yaml::Node& map);
  /// Returns the forms of a scalar.
  FormList scalars(const FormList& forms);

  const yaml::Key& block_form(const BlockType& type);
  /// Sets the lookup of part files by the text of the key `diagram`. It returns nullptr for an unreadable
  /// file.
  using Parts = std::function<std::shared_ptr<const yaml::Document>(const std::string& path)>;
  void look_for_parts(Parts parts) { parts_ = std::move(parts); }

 private:
  void expand(const yaml::Key& form, FormList& result, int depth = 0);
  FormList expanded(const FormList& forms);
  void add_block(const yaml::Node& map, FormList& result);
  void add_figure(const yaml::Node& map, bool panel, FormList& result);
  const yaml::Key& any_block();

  const Registry& registry_;
  Parts parts_;
  std::map<std::string, std::unique_ptr<const yaml::Key>> made_;
  /// forms of parts, by document
  std::map<std::shared_ptr<const yaml::Document>, std::unique_ptr<const yaml::Key>> of_parts_;
};

/// True for the form of a block, whose keys depend on its type.
bool is_block_form(const yaml::Key& form);

/// Name in a file, possibly dotted, with its range and the kind of thing it can refer to.
struct WrittenName {
  enum class Sense {
    signal,     ///< Signal of a block or port, or swept parameter: rig.x
    parameter,  ///< Parameter: $mass, mass in "= mass*2", rig.mass in a sweep
    block,      ///< Key of a block, its definition.
    input,      ///< Key of an input, its definition.
    output,
    defined,    ///< Key of a parameter, its definition.
    inside,     ///< Block, part or signal, possibly within parts.
    part_key,   ///< Key of a part: the name of its input or parameter.
    block_key,  ///< Key of a block.
    type,       ///< Type of a block.
    file        ///< File of a part.
  };
  TextRange range;
  std::string name;
  Sense sense;
  std::string block;  ///< block whose map contains the name
};

/// Returns all names of a diagram file in the order of the text, from which the document was parsed.
std::vector<WrittenName> written_names(const yaml::Document& document, std::string_view text, Forms& forms);

/// Name in an expression: its range, and true if it is a parameter after '$'.
struct NameInText {
  TextRange range;
  bool parameter = false;
};

/// True for a letter, a digit or '_', which names consist of.
bool is_name_character(char c);

/// Returns the names of an expression, which need not be valid. Units after numbers are no names.
std::vector<NameInText> names_in_expression(std::string_view text);

}  // namespace stepwire::language
