#include "engine/base/archive/archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cstdint>

#include "engine/base/io/file.hpp"
#include "engine/base/io/inside.hpp"

namespace stepwire::archive {

namespace fs = std::filesystem;

namespace {

constexpr time_t long_ago = 315532800;  // 1980-01-01, the earliest date of the zip format

[[noreturn]] void give_up(zip_t* zip) {
  const std::string reason = zip_strerror(zip);
  zip_discard(zip);
  throw ArchiveError(fmt::format("an archive cannot be made: {}", reason));
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

Archive::Archive(const std::string& path, std::string kind) : path_(path), kind_(std::move(kind)) {
  io::require_inside(path);
  int reason = 0;
  zip_t* opened = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &reason);
  if (!opened) {
    zip_error_t error;
    zip_error_init_with_code(&error, reason);
    const std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw ArchiveError(
        fmt::format("{0} is no {1} that can be read: {2}; a {1} is a zip archive", path, kind_, text));
  }
  handle_ = std::make_unique<Handle>(opened);
  read_entries();
}

void Archive::read_entries() {
  const zip_int64_t count = zip_get_num_entries(handle_->zip, 0);
  if (count > max_entries)
    throw ArchiveError(fmt::format("{} has {} entries, and a {} may have {}; nothing of it is unpacked",
                                   path_, count, kind_, max_entries));
  const std::uint64_t most = max_unpacked(path_);
  std::uint64_t whole = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t about;
    zip_stat_init(&about);
    zip_stat_index(handle_->zip, static_cast<zip_uint64_t>(i), 0, &about);
    names_.emplace_back(about.name ? about.name : "");
    if (leads_out(names_.back()))
      throw ArchiveError(fmt::format(
          "{} has an entry '{}' that leads out of the archive; nothing of it is used", path_, names_.back()));
    whole += std::min(about.size, most + 1);  // no overflow: each summand is at most most + 1
  }
  if (whole > most)
    throw ArchiveError(fmt::format(
        "{} unpacks to {} MiB or more, and a {} of its size may unpack to {} MiB; nothing of it is "
        "unpacked",
        path_, whole / mebibyte, kind_, most / mebibyte));
}

Archive::~Archive() = default;

bool Archive::contains(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::string Archive::read(const std::string& name) const {
  zip_stat_t about;
  if (zip_stat(handle_->zip, name.c_str(), 0, &about) != 0)
    throw ArchiveError(fmt::format("{} has no {}", path_, name));
  std::string bytes(about.size, '\0');
  zip_file_t* file = zip_fopen(handle_->zip, name.c_str(), 0);
  const zip_int64_t count = file ? zip_fread(file, bytes.data(), about.size) : -1;
  // zip_fread() verifies the checksum of an entry only at its end.
  char beyond = 0;
  const bool whole = count == static_cast<zip_int64_t>(about.size) && zip_fread(file, &beyond, 1) == 0;
  if (file) zip_fclose(file);
  if (!whole) throw ArchiveError(fmt::format("{} in {} is damaged", name, path_));
  return bytes;
}

void Archive::unpack(const std::string& start, const fs::path& folder) const {
  for (const std::string& name : names_)
    if (name.starts_with(start) && !name.ends_with('/')) io::write_file((folder / name).string(), read(name));
}

std::string archive_bytes(const std::map<std::string, std::string>& files) {
  zip_source_t* made = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_t* zip = made ? zip_open_from_source(made, ZIP_TRUNCATE, nullptr) : nullptr;
  if (!zip) throw ArchiveError("an archive cannot be made: there is no memory for it");
  zip_source_keep(made);
  for (const auto& [name, content] : files) add(zip, name, content);
  if (zip_close(zip) != 0) {
    zip_source_free(made);
    give_up(zip);
  }
  std::string bytes = bytes_of(made);
  zip_source_free(made);
  if (bytes.empty()) throw ArchiveError("an archive cannot be made: its bytes are lost");
  return bytes;
}

}  // namespace stepwire::archive
