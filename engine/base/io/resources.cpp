#include "engine/base/io/resources.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* share = "share/stepwire";
constexpr int folders_above_program = 2;  // bin of a prefix; tests of a build folder

std::string& package() {
  static std::string of_package;
  return of_package;
}

/// Returns the text how to install the folder of this name.
std::string source_of(const std::string& name) {
  if (name == "mpi")
    return "'./stepwire setup mpi' in a checkout builds it with the Debian packages libopenmpi-dev and "
           "openmpi-bin, and './stepwire install' puts it into a prefix";
  const bool is_for_compilers = name == "headers" || name == "public" || name == "eigen";
  return fmt::format(
      "the Debian package {} has it, and './stepwire install' in a checkout puts it into a prefix",
      is_for_compilers ? "libstepwire-dev" : "stepwire");
}

/// Returns the possible locations, the most likely one first.
std::vector<fs::path> candidates() {
  if (const char* named = std::getenv("STEPWIRE_HOME"); named && *named)
    return {fs::path(named), fs::path(named) / share};
  std::vector<fs::path> places;
  if (!package().empty()) places.emplace_back(package());
  std::error_code none;
  fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (int above = 0; above <= folders_above_program && !folder.empty(); ++above) {
    places.push_back(folder / share);
    folder = folder.parent_path();
  }
  return places;
}

}  // namespace

void note_package(std::string share) {
  package() = std::move(share);
}

std::string find_resource(const std::string& name) {
  for (const fs::path& place : candidates()) {
    std::error_code none;
    const fs::path found = fs::canonical(place / name, none);
    if (!none && fs::is_directory(found, none)) return found.string();
  }
  return "";
}

std::string resource(const std::string& name) {
  if (std::string found = find_resource(name); !found.empty()) return found;
  std::string places;
  for (const fs::path& place : candidates()) places += (places.empty() ? "" : ", ") + (place / name).string();
  throw EnvironmentError(
      fmt::format("the folder '{}' that comes with stepwire is not there: {}; {}. STEPWIRE_HOME names the "
                  "folder {} of an installation",
                  name, places, source_of(name), share));
}

}  // namespace stepwire::io
