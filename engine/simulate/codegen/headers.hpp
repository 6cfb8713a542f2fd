#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

// A header is named by its path from the root of our sources ("blocks/math/gain.hpp"), as one of the public
// ones ("stepwire/block.hpp"), or, where it came with somebody else's block, by its full path.

/// Headers of a program, with all that they include of ours and of those who wrote their blocks.
struct IncludedHeaders {
  std::vector<std::string> all;  ///< sorted
  /// Folders from which headers of others include theirs: a folder above the including one, where it is not
  /// that one itself.
  std::vector<std::string> folders;
};

IncludedHeaders with_included(const std::vector<std::string>& headers);

/// The text of a header. Throws EnvironmentError where it is not there.
std::string header_text(const std::string& header);

/// That of what expressions call.
inline constexpr const char* language_header = "engine/base/expression/language.hpp";

/// Refuses what only the program itself can run: throws Error with the lines of all such blocks.
void require_headers(const plan::Plan& plan);

/// The headers that the code of a plan needs, from the root of the sources, sorted.
std::vector<std::string> headers_of(const plan::Plan& plan);

/// Has it a full path, and is none of ours?
bool is_of_others(const std::string& header);

/// Options for the compiler, which then finds what headers of others include, after what is ours.
std::vector<std::string> include_options(const IncludedHeaders& headers);

}  // namespace stepwire::codegen
