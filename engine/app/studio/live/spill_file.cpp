#include "engine/app/studio/live/spill_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::live {

namespace {

[[noreturn]] void refuse(const std::string& folder, const char* what) {
  throw io::EnvironmentError(
      fmt::format("{}: the samples of the run cannot be {}: {}", folder, what, std::strerror(errno)));
}

constexpr std::uint64_t left_free = std::uint64_t{1} << 30;       // bytes of free disk space
constexpr std::uint64_t between_looks = std::uint64_t{64} << 20;  // bytes written between checks of the disk

int open_without_name(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  std::string name = folder + "/stepwire-samples-XXXXXX";  // for file systems without O_TMPFILE
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

SpillFile::SpillFile(const std::string& folder, std::size_t chunk)
    : folder_(folder), chunk_bytes_(chunk * sizeof(double)), file_(open_without_name(folder)) {
  if (!file_.open()) refuse(folder_, "kept");
}

std::uint64_t SpillFile::write(std::span<const double> chunk) {
  const bool again = !free_.empty();
  if (!again && end_ % between_looks == 0) leave_room();
  const std::uint64_t place = again ? free_.back() : end_;
  const char* bytes = reinterpret_cast<const char*>(chunk.data());
  for (std::size_t done = 0; done < chunk.size_bytes();) {
    const auto written =
        ::pwrite(file_.number(), bytes + done, chunk.size_bytes() - done, static_cast<off_t>(place + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) refuse(folder_, "written");
    done += static_cast<std::size_t>(written);
  }
  if (again) free_.pop_back();
  if (!again) end_ += chunk_bytes_;
  return place;
}

/// Throws if the disk is nearly full, as a run may continue without end.
void SpillFile::leave_room() const {
  std::error_code unknown;
  const std::filesystem::space_info space = std::filesystem::space(folder_, unknown);
  if (unknown || space.available > left_free) return;
  throw io::EnvironmentError(
      fmt::format("{}: the samples of the run leave less than 1 GiB of the disk free", folder_));
}

void SpillFile::read(std::uint64_t place, std::size_t first, std::span<double> into) const {
  char* bytes = reinterpret_cast<char*>(into.data());
  const std::uint64_t begin = place + first * sizeof(double);
  for (std::size_t done = 0; done < into.size_bytes();) {
    const auto count =
        ::pread(file_.number(), bytes + done, into.size_bytes() - done, static_cast<off_t>(begin + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(folder_, "read");
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace stepwire::live
