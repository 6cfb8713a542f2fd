#include "engine/base/fmi/archive_bytes.hpp"

#include <fmt/format.h>
#include <zip.h>

#include "engine/base/fmi/unit_error.hpp"

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

}  // namespace stepwire::fmi
