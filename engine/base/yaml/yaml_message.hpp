#pragma once

#include <string>
#include <string_view>

namespace stepwire::yaml {

/// Rewrites an error message of the YAML library, which uses terms of parser authors, for users.
std::string yaml_message(std::string_view library_message);

}  // namespace stepwire::yaml
