#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

// A header of stepwire is named by its path from the root of the sources ("blocks/math/gain.hpp") or as a
// public one ("stepwire/block.hpp"). A header of a foreign block has its full path.

/// Headers of a program, with all included headers of stepwire and of foreign blocks.
struct IncludedHeaders {
  std::vector<std::string> all;  ///< sorted
  /// Include folders of foreign headers: folders above the including header from which its includes are
  /// found.
  std::vector<std::string> folders;
};

IncludedHeaders with_included(const std::vector<std::string>& headers);

/// Returns the text of a header. Throws EnvironmentError if it is missing.
std::string header_text(const std::string& header);

/// Header of the functions that expressions call.
inline constexpr const char* language_header = "engine/base/expression/language.hpp";

/// Throws Error with the lines of all blocks that only stepwire itself can run.
void require_headers(const plan::Plan& plan);

/// Returns the headers that the code of a plan needs, from the root of the sources, sorted.
std::vector<std::string> headers_of(const plan::Plan& plan);

/// True for a header of a foreign block, with a full path.
bool is_of_others(const std::string& header);

/// Returns the compiler options that add the include folders of foreign headers after those of stepwire.
std::vector<std::string> include_options(const IncludedHeaders& headers);

}  // namespace stepwire::codegen
