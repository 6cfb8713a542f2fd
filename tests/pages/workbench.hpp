#pragma once

#include <string>
#include <vector>

#include "tests/engine/base/table/scratch.hpp"

/// The output of a command, of both streams, and its exit status.
struct Outcome {
  int code = -1;
  std::string output;
};

/// A folder in which the commands of a page run as if at the top of the source tree: ./stepwire is the built
/// program, diagrams/ is that of the tree. Files that the commands write stay in the folder.
class Workbench {
 public:
  Workbench();
  void write(const std::string& name, const std::string& text) const;
  Outcome run(const std::string& command) const;

 private:
  Scratch folder_;
};

/// All of a file; empty if it is not there.
std::string content_of(const std::filesystem::path& file);

/// Returns the output of the program for these arguments.
std::string printed_by_program(const std::string& arguments);
