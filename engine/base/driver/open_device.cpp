#include "engine/base/driver/open_device.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::driver {

namespace {

namespace fs = std::filesystem;

constexpr const char* place = "lib/stepwire";
constexpr int folders_above_program = 2;  // bin of a prefix; tests of a build folder
constexpr std::size_t text_bytes = 2048;

std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(':', at), text.size());
    if (end > at) parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// Returns the folders lib/stepwire of this installation, the nearest one first.
std::vector<fs::path> libraries() {
  std::vector<fs::path> found;
  std::error_code none;
  fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (int above = 0; above <= folders_above_program && !folder.empty(); ++above) {
    if (fs::is_directory(folder / place, none)) found.push_back(folder / place);
    folder = folder.parent_path();
  }
  return found;
}

std::string unknown_driver(const std::string& name) {
  std::vector<std::string> names;
  for (const FoundDriver& found : found_drivers()) names.push_back(found.name);
  return fmt::format("there is no driver '{}'; {} in {}. STEPWIRE_DRIVERS names further folders", name,
                     names.empty() ? "there is none" : fmt::format("there are {}", fmt::join(names, ", ")),
                     fmt::join(driver_folders(), ", "));
}

/// Throws where a shared object ends before the last segment of its table. The loader would map the missing
/// pages, and the first access there would end the process by SIGBUS.
void require_all_bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  Elf64_Ehdr head{};
  if (!stream.read(reinterpret_cast<char*>(&head), sizeof head) ||
      std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 || head.e_phentsize != sizeof(Elf64_Phdr))
    return;  // dlopen() refuses it
  std::vector<Elf64_Phdr> segments(head.e_phnum);
  stream.seekg(static_cast<std::streamoff>(head.e_phoff));
  const auto bytes = static_cast<std::streamsize>(segments.size() * sizeof(Elf64_Phdr));
  bool whole = static_cast<bool>(stream.read(reinterpret_cast<char*>(segments.data()), bytes));
  const std::uintmax_t size = fs::file_size(file);
  for (const Elf64_Phdr& one : segments) whole = whole && one.p_offset + one.p_filesz <= size;
  if (!whole) throw io::EnvironmentError(fmt::format("the driver {} is cut off; copy it again", file));
}

/// Throws where a function is missing that every driver has.
void require_whole(const stepwire_driver* driver, const std::string& file) {
  if (!driver || driver->version != STEPWIRE_DRIVER_VERSION)
    throw io::EnvironmentError(
        fmt::format("the driver {} has another version of the interface than {}; compile it with "
                    "this version's driver.h",
                    file, STEPWIRE_DRIVER_VERSION));
  const bool whole = driver->name && driver->doc && driver->settings && driver->open && driver->channels &&
                     driver->start && driver->read && driver->write && driver->safe && driver->stop &&
                     driver->close && driver->report;
  if (!whole) throw io::EnvironmentError(fmt::format("the driver {} lacks a function of driver.h", file));
}

}  // namespace

std::vector<std::string> driver_folders() {
  std::vector<std::string> folders;
  for (const fs::path& library : libraries()) folders.push_back((library / "drivers").string());
  if (const char* named = std::getenv("STEPWIRE_DRIVERS"))
    for (std::string& one : split_at_colons(named)) folders.push_back(std::move(one));
  return folders;
}

std::string program_file(const std::string& name) {
  for (const fs::path& library : libraries())
    if (::access((library / name).c_str(), X_OK) == 0) return (library / name).string();
  throw io::EnvironmentError(
      fmt::format("the program {}/{} is not there; './stepwire' builds it", place, name));
}

std::vector<FoundDriver> found_drivers() {
  std::map<std::string, std::string> files;
  for (const std::string& folder : driver_folders()) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
      if (entry.path().extension() == ".so" && entry.is_regular_file(none))
        files.emplace(entry.path().stem().string(), entry.path().string());
  }
  std::vector<FoundDriver> found;
  for (const auto& [name, file] : files) found.push_back({name, file});
  return found;
}

std::string driver_file(const std::string& name) {
  for (const FoundDriver& found : found_drivers())
    if (found.name == name) return found.file;
  throw io::EnvironmentError(unknown_driver(name));
}

const stepwire_driver& load_driver(const std::string& file) {
  require_all_bytes(file);
  void* const object = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  using Entry = const stepwire_driver* (*)();
  const auto entry = object ? reinterpret_cast<Entry>(::dlsym(object, "stepwire_driver_v1")) : nullptr;
  if (!entry)
    throw io::EnvironmentError(fmt::format("the driver {} cannot be loaded: {}", file, ::dlerror()));
  const stepwire_driver* const driver = entry();
  require_whole(driver, file);
  return *driver;
}

/// Returns the reason of a driver for a failed function, or the name of that function for an empty reason.
static std::string reason_of(const stepwire_driver& driver, const char* text, const char* function) {
  const std::string reason = *text ? text : fmt::format("{} has failed without a reason", function);
  return fmt::format("driver {}: {}", driver.name, reason);
}

static void* open_with(const stepwire_driver& driver, const Settings& settings) {
  std::vector<stepwire_setting> all;
  for (const auto& [key, value] : settings) all.push_back({key.c_str(), value.c_str()});
  std::array<char, text_bytes> error{};
  void* const device = driver.open(all.data(), all.size(), error.data(), error.size());
  if (!device) throw io::EnvironmentError(reason_of(driver, error.data(), "open"));
  return device;
}

OpenDevice::OpenDevice(const stepwire_driver& driver, const Settings& settings)
    : driver_(driver), device_(open_with(driver, settings)) {
  const stepwire_channel* table = nullptr;
  const std::size_t count = driver_.channels(device_, &table);
  for (std::size_t i = 0; i < count; ++i)
    (table[i].direction == STEPWIRE_INPUT ? inputs_ : outputs_).push_back(table[i]);
}

OpenDevice::~OpenDevice() {
  stop();
  driver_.close(device_);
}

bool OpenDevice::is_ready() {
  const int state = ready();
  if (state < 0)
    throw io::EnvironmentError(fmt::format("driver {}: the device does not answer", driver_.name));
  return state > 0;
}

void OpenDevice::start(std::int64_t period, const double* safe) {
  std::array<char, text_bytes> error{};
  if (driver_.start(device_, period, safe, error.data(), error.size()) != 0)
    throw io::EnvironmentError(reason_of(driver_, error.data(), "start"));
  started_ = true;
}

void OpenDevice::stop() noexcept {
  if (std::exchange(started_, false)) driver_.stop(device_);
}

std::string OpenDevice::report() const {
  std::array<char, text_bytes> text{};
  driver_.report(device_, text.data(), text.size());
  return text.data();
}

}  // namespace stepwire::driver
