#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace stepwire::cli {

/// Validator of an option that takes one word of a list. A misspelt word is refused with the nearest one.
class Choice : public CLI::IsMember {
 public:
  explicit Choice(const std::vector<std::string>& words);
};

/// Returns the names of the long options of a verb or program, with dashes.
std::vector<std::string> long_options(const CLI::App& app);

/// Returns the message about a call with a fault: for an unknown option, with the nearest one of its verb.
std::string fault_of_call(const CLI::App& program, const CLI::Error& error);

}  // namespace stepwire::cli
