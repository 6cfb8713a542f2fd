#pragma once

#include <string>

#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::codegen {

/// C interface of a generated program. Its names begin with `space`; those of macros are in capitals.
struct CInterface {
  std::string header;  ///< C99
  std::string source;  ///< C++
};

/// `header` is the name of the C++ header, `c_header` that of the C header.
CInterface c_interface(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                       const std::string& space, const std::string& header, const std::string& c_header);

}  // namespace stepwire::codegen
