#include "engine/base/fmi/package.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdint>
#include <mutex>
#include <set>
#include <tuple>
#include <vector>

#include "engine/base/archive/archive.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/io/inside.hpp"

namespace stepwire::fmi {

namespace {

using archive::Archive;

namespace fs = std::filesystem;

std::string platforms_of(const Archive& archive) {
  std::set<std::string> found;
  for (const std::string& name : archive.names()) {
    const std::size_t end = name.find('/', 9);
    if (name.starts_with("binaries/") && end != name.npos) found.insert(name.substr(9, end - 9));
  }
  return found.empty() ? "no binaries at all" : fmt::format("binaries for {}", fmt::join(found, ", "));
}

/// Rethrows an error with the path of the file.
[[noreturn]] void refuse(const std::string& path, const UnitError& error) {
  const std::string text = error.what();
  throw UnitError(text.starts_with(path) ? text : fmt::format("{} cannot be used: {}", path, text));
}

/// Path, size and time of change of a file, which identify its content.
using FileState = std::tuple<std::string, std::uintmax_t, fs::file_time_type>;

FileState state_of(const std::string& path) {
  std::error_code none;
  io::require_inside(path);
  const fs::path whole = fs::canonical(path, none);
  if (none || !fs::is_regular_file(whole)) throw UnitError(fmt::format("there is no file {}", path));
  return {whole.string(), fs::file_size(whole), fs::last_write_time(whole)};
}

/// Throws UnitError if there is no binary of the interface for this platform.
void unpack_binaries(const Archive& archive, const Interface& of, int version, const fs::path& folder) {
  const std::string here = binary_folder(version);
  if (!archive.contains(fmt::format("{}{}.so", here, of.identifier)))
    throw UnitError(fmt::format("it has {}, and none for this platform: {}{}.so is missing",
                                platforms_of(archive), here, of.identifier));
  archive.unpack(here, folder);
}

}  // namespace

std::string binary_folder([[maybe_unused]] int version) {
#if defined(__aarch64__)
  return "binaries/aarch64-linux/";
#else
  return version == 2 ? "binaries/linux64/" : "binaries/x86_64-linux/";
#endif
}

Package::Package(const std::string& path) : path_(path) {
  try {
    const Archive archive(path, "unit");
    if (!archive.contains("modelDescription.xml"))
      throw UnitError("it has no modelDescription.xml; a unit of FMI 2 or 3 has one at its root");
    description_ = read_description(archive.read("modelDescription.xml"));
    if (folder_.path().empty())
      throw UnitError("cannot be unpacked: no folder can be made for it; TMPDIR names where");
    for (const Interface* one : {&description_.co_simulation, &description_.model_exchange})
      if (!one->identifier.empty()) unpack_binaries(archive, *one, description_.version, folder());
    archive.unpack("resources/", folder());
  } catch (const archive::ArchiveError& error) {
    refuse(path, UnitError(error.what()));
  } catch (const UnitError& error) {
    refuse(path, error);
  }
}

fs::path Package::folder() const {
  return folder_.path();
}

std::string Package::binary(const Interface& of) const {
  return (folder() / binary_folder(description_.version) / (of.identifier + ".so")).string();
}

std::string Package::resources() const {
  return (folder() / "resources").string() + "/";
}

std::string Package::resources_uri() const {
  return "file://" + (folder() / "resources").string();
}

std::shared_ptr<const Package> open_package(const std::string& path) {
  static std::mutex mutex;
  static std::map<FileState, std::weak_ptr<const Package>> open;
  const FileState state = state_of(path);
  const std::lock_guard lock(mutex);
  auto& slot = open[state];
  if (auto known = slot.lock()) return known;
  auto made = std::make_shared<const Package>(path);
  slot = made;
  return made;
}

}  // namespace stepwire::fmi
