#pragma once

#include <string>
#include <string_view>

namespace stepwire::yaml {

/// What the YAML library complains about, in words that help: its terms are those of a parser's author.
std::string yaml_message(std::string_view library_message);

}  // namespace stepwire::yaml
