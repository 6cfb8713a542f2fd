#pragma once

#include <string>
#include <vector>

#include "engine/app/language/forms.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

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
