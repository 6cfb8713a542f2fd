#pragma once

#include <string>
#include <vector>

namespace stepwire {

/// What a program said that was given a text.
struct FilterAnswer {
  std::string output;
  std::string complaints;  ///< its standard error, without blanks around it
  int status = -1;         ///< its exit status; -1 if it was killed
};

/// The full path of a program on the PATH, or empty.
std::string find_program(const std::string& name);

/// Runs a program with a text as its standard input, and waits for it. Throws SurroundingsError where it
/// cannot be run.
FilterAnswer run_filter(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& input);

}  // namespace stepwire
