#include "engine/base/fmi/package.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <set>
#include <tuple>
#include <vector>

#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/inside.hpp"

namespace stepwire::fmi {

namespace {

constexpr time_t long_ago = 315532800;  // 1980-01-01, the earliest date of the zip format

[[noreturn]] void give_up(zip_t* zip) {
  const std::string reason = zip_strerror(zip);
  zip_discard(zip);
  throw UnitError(fmt::format("an archive cannot be made: {}", reason));
}

void add(zip_t* zip, const std::string& name, const std::string& content) {
  zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
  const zip_int64_t index = source ? zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) {
    if (source) zip_source_free(source);
    give_up(zip);
  }
  zip_file_set_mtime(zip, static_cast<zip_uint64_t>(index), long_ago, 0);
}

std::string bytes_of(zip_source_t* made) {
  std::string bytes;
  zip_stat_t about;
  zip_stat_init(&about);
  if (zip_source_stat(made, &about) == 0 && zip_source_open(made) == 0) {
    bytes.resize(about.size);
    if (zip_source_read(made, bytes.data(), about.size) != static_cast<zip_int64_t>(about.size))
      bytes.clear();
    zip_source_close(made);
  }
  return bytes;
}

/// A zip archive opened for reading. No entry may have a path outside of the folder of extraction.
class Archive {
 public:
  /// Throws UnitError for another format, for paths that lead out of the archive, and for too many bytes or
  /// entries.
  explicit Archive(const std::string& path);
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  const std::vector<std::string>& names() const { return names_; }
  bool contains(const std::string& name) const;
  /// Returns all bytes of an entry. Throws UnitError if it is missing or damaged.
  std::string read(const std::string& name) const;
  /// Extracts the entries that begin with `start` below a folder. Throws UnitError.
  void unpack(const std::string& start, const std::filesystem::path& folder) const;

 private:
  struct Handle;
  void read_entries();

  std::string path_;
  std::unique_ptr<Handle> handle_;
  std::vector<std::string> names_;
};

namespace fs = std::filesystem;

constexpr zip_int64_t max_entries = 20'000;
constexpr std::uint64_t mebibyte = 1u << 20u;

/// Returns the most bytes that an archive may unpack to: 20 times its own size, between 256 MiB and 4 GiB.
/// Real units have less; zeros unpack to 1000 times their archive.
std::uint64_t max_unpacked(const std::string& path) {
  std::error_code none;
  const std::uint64_t own = fs::file_size(path, none);
  return none ? 256 * mebibyte : std::clamp<std::uint64_t>(20 * own, 256 * mebibyte, 4096 * mebibyte);
}

bool leads_out(const std::string& name) {
  if (name.empty() || name[0] == '/' || name.find('\\') != name.npos || name.find('\0') != name.npos)
    return true;
  return std::ranges::any_of(fs::path(name), [](const fs::path& part) { return part == ".."; });
}

struct Archive::Handle {
  explicit Handle(zip_t* opened) : zip(opened) {}
  Handle(const Handle&) = delete;
  ~Handle() { zip_discard(zip); }
  zip_t* zip;
};

Archive::Archive(const std::string& path) : path_(path) {
  io::require_inside(path);
  int reason = 0;
  zip_t* opened = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &reason);
  if (!opened) {
    zip_error_t error;
    zip_error_init_with_code(&error, reason);
    const std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw UnitError(fmt::format("{} is no unit that can be read: {}; a unit is a zip archive", path, text));
  }
  handle_ = std::make_unique<Handle>(opened);
  read_entries();
}

void Archive::read_entries() {
  const zip_int64_t count = zip_get_num_entries(handle_->zip, 0);
  if (count > max_entries)
    throw UnitError(fmt::format("{} has {} entries, and a unit may have {}; nothing of it is unpacked", path_,
                                count, max_entries));
  const std::uint64_t most = max_unpacked(path_);
  std::uint64_t whole = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t about;
    zip_stat_init(&about);
    zip_stat_index(handle_->zip, static_cast<zip_uint64_t>(i), 0, &about);
    names_.emplace_back(about.name ? about.name : "");
    if (leads_out(names_.back()))
      throw UnitError(fmt::format("{} has an entry '{}' that leads out of the archive; nothing of it is used",
                                  path_, names_.back()));
    whole += std::min(about.size, most + 1);  // no overflow: each summand is at most most + 1
  }
  if (whole > most)
    throw UnitError(fmt::format(
        "{} unpacks to {} MiB or more, and a unit of its size may unpack to {} MiB; nothing of it is "
        "unpacked",
        path_, whole / mebibyte, most / mebibyte));
}

Archive::~Archive() = default;

bool Archive::contains(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::string Archive::read(const std::string& name) const {
  zip_stat_t about;
  if (zip_stat(handle_->zip, name.c_str(), 0, &about) != 0)
    throw UnitError(fmt::format("{} has no {}", path_, name));
  std::string bytes(about.size, '\0');
  zip_file_t* file = zip_fopen(handle_->zip, name.c_str(), 0);
  const zip_int64_t count = file ? zip_fread(file, bytes.data(), about.size) : -1;
  // zip_fread() verifies the checksum of an entry only at its end.
  char beyond = 0;
  const bool whole = count == static_cast<zip_int64_t>(about.size) && zip_fread(file, &beyond, 1) == 0;
  if (file) zip_fclose(file);
  if (!whole) throw UnitError(fmt::format("{} in {} is damaged", name, path_));
  return bytes;
}

void Archive::unpack(const std::string& start, const fs::path& folder) const {
  for (const std::string& name : names_)
    if (name.starts_with(start) && !name.ends_with('/')) io::write_file((folder / name).string(), read(name));
}

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

std::string archive_bytes(const std::map<std::string, std::string>& files) {
  zip_source_t* made = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_t* zip = made ? zip_open_from_source(made, ZIP_TRUNCATE, nullptr) : nullptr;
  if (!zip) throw UnitError("an archive cannot be made: there is no memory for it");
  zip_source_keep(made);
  for (const auto& [name, content] : files) add(zip, name, content);
  if (zip_close(zip) != 0) {
    zip_source_free(made);
    give_up(zip);
  }
  std::string bytes = bytes_of(made);
  zip_source_free(made);
  if (bytes.empty()) throw UnitError("an archive cannot be made: its bytes are lost");
  return bytes;
}

std::string binary_folder([[maybe_unused]] int version) {
#if defined(__aarch64__)
  return "binaries/aarch64-linux/";
#else
  return version == 2 ? "binaries/linux64/" : "binaries/x86_64-linux/";
#endif
}

Package::Package(const std::string& path) : path_(path) {
  try {
    const Archive archive(path);
    if (!archive.contains("modelDescription.xml"))
      throw UnitError("it has no modelDescription.xml; a unit of FMI 2 or 3 has one at its root");
    description_ = read_description(archive.read("modelDescription.xml"));
    if (folder_.path().empty())
      throw UnitError("cannot be unpacked: no folder can be made for it; TMPDIR names where");
    for (const Interface* one : {&description_.co_simulation, &description_.model_exchange})
      if (!one->identifier.empty()) unpack_binaries(archive, *one, description_.version, folder());
    archive.unpack("resources/", folder());
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
