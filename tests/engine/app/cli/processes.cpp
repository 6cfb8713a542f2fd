#include "tests/engine/app/cli/processes.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace {

namespace fs = std::filesystem;

bool lives(const fs::path& process) {
  std::ifstream status(process / "stat");
  std::string number, name, state;
  return static_cast<bool>(status >> number >> name >> state) && state != "Z";
}

int count_now(const fs::path& folder) {
  int count = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", none)) {
    const fs::path works_in = fs::read_symlink(entry.path() / "cwd", none);
    if (!none && works_in == folder && lives(entry.path())) ++count;
  }
  return count;
}

}  // namespace

int processes_in(const std::string& folder) {
  const fs::path whole = fs::canonical(folder);
  for (int look = 0; look < 40 && count_now(whole) > 0; ++look)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  return count_now(whole);
}
