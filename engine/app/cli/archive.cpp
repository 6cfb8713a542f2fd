#include "engine/app/cli/archive.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <vector>

#include "engine/app/cli/console.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/temporary.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::cli {

namespace fs = std::filesystem;

namespace {

/// Runs tar. Throws EnvironmentError with the first line of its errors.
void make(const std::vector<std::string>& command) {
  try {
    subprocess::run_helper("tar", {.command = command});
  } catch (const io::EnvironmentError& error) {
    const std::string words = error.what();
    throw io::EnvironmentError(words.substr(0, words.find('\n')));
  }
}

}  // namespace

void put_archive(const std::string& folder, const std::string& file) {
  std::vector<std::string> command{
      "tar",         "--create",   "--format=gnu", "--file=" + file, "--directory=" + folder,
      "--sort=name", "--mtime=@0", "--owner=0",    "--group=0",      "--numeric-owner",
      "--"};
  const std::size_t options = command.size();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    command.push_back(entry.path().filename().string());
  std::sort(command.begin() + static_cast<std::ptrdiff_t>(options), command.end());
  if (command.size() == options) return;  // no run has written a file
  make(command);
  std::ifstream archive(file, std::ios::binary);
  std::array<char, 1 << 16> block;
  while (archive.read(block.data(), block.size()) || archive.gcount() > 0)
    put_data({block.data(), static_cast<std::size_t>(archive.gcount())});
  if (!archive.eof()) io::refuse_file(file, errno);
}

}  // namespace stepwire::cli
