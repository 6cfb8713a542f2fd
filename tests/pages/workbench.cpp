#include "tests/pages/workbench.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <iterator>

namespace fs = std::filesystem;

Workbench::Workbench() {
  const fs::path source = STEPWIRE_SOURCE_DIR;
  fs::create_directory_symlink(source / "diagrams", folder_.path("diagrams"));
  fs::create_symlink(STEPWIRE_PROGRAM, folder_.path("stepwire"));
}

void Workbench::write(const std::string& name, const std::string& text) const {
  folder_.file(name, text);
}

Outcome Workbench::run(const std::string& command) const {
  folder_.file(".command", command + "\n");
  const std::string call =
      "cd '" + folder_.path("") + "' && timeout 120 sh .command > .output 2>&1 < /dev/null";
  const int status = std::system(call.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder_.path(".output"))};
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string printed_by_program(const std::string& arguments) {
  return Workbench().run("./stepwire " + arguments).output;
}
