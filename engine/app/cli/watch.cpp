#include "engine/app/cli/watch.hpp"

#include <fmt/chrono.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <map>
#include <thread>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/model/diagram/flatten.hpp"

namespace stepwire::cli {

namespace {

constexpr std::chrono::milliseconds between_looks{200};

/// Time and size of a file, by which changes are detected.
struct Stamp {
  std::filesystem::file_time_type time{};
  std::uintmax_t size = 0;
  bool operator==(const Stamp&) const = default;
};

using Stamps = std::map<std::string, Stamp>;

Stamp stamp_of(const std::string& file) {
  std::error_code none;
  Stamp stamp{std::filesystem::last_write_time(file, none), 0};
  if (!none) stamp.size = std::filesystem::file_size(file, none);
  return stamp;
}

Stamps now(const Stamps& files) {
  Stamps stamps;
  for (const auto& [file, before] : files) stamps[file] = stamp_of(file);
  return stamps;
}

/// False after an interruption.
bool wait_for_change(const Stamps& before) {
  while (!interrupted()) {
    if (now(before) != before) return true;
    std::this_thread::sleep_for(between_looks);
  }
  return false;
}

}  // namespace

void WatchedFiles::add(const diagram::Loader& loader) {
  for (std::string& path : loader.paths()) files_.push_back(std::move(path));
}

void WatchedFiles::add(const diagram::Diagram& diagram) {
  static_cast<void>(diagram::flattened_text(diagram, [&](const std::string& path) {
    files_.push_back(path);
    return path;
  }));
}

ExitCode watch(const std::function<void(WatchedFiles&)>& round) {
  const EndDelay delay(EndDelay::Signals::first);
  Stamps seen;
  do {
    Stamps next = now(seen);  // taken before the round, so that changes during it start the next one
    WatchedFiles watched;
    round(watched);
    finish_output();
    for (const std::string& file : watched.files()) next.try_emplace(file, stamp_of(file));
    seen = std::move(next);
  } while (wait_for_change(seen));
  return ExitCode::interrupted;
}

std::string time_of_day() {
  return fmt::format("{:%H:%M:%S}", fmt::localtime(std::time(nullptr)));
}

}  // namespace stepwire::cli
