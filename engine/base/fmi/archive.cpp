#include "engine/base/fmi/archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cstdint>

#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::fmi {

namespace {

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

}  // namespace

struct Archive::Handle {
  explicit Handle(zip_t* opened) : zip(opened) {}
  Handle(const Handle&) = delete;
  ~Handle() { zip_discard(zip); }
  zip_t* zip;
};

Archive::Archive(const std::string& path) : path_(path) {
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

}  // namespace stepwire::fmi
