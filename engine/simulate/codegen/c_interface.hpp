#pragma once

#include <string>

#include "engine/simulate/codegen/groups.hpp"

namespace stepwire::codegen {

/// How a generated program is called from C: its names begin with `space`, those of macros are in capitals.
struct CInterface {
  std::string header;  ///< of C99
  std::string source;  ///< of C++
};

/// `header` is the name of the C++ header, `c_header` that of this one.
CInterface c_interface(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                       const std::string& space, const std::string& header, const std::string& c_header);

}  // namespace stepwire::codegen
