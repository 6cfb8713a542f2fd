#pragma once

#include <unistd.h>

#include <array>
#include <string>

namespace stepwire::cluster {

/// First byte of a message between process 0 and a worker, its kind. The trailing comments give the content
/// that follows.
namespace kind {

// Messages to process 0.
inline constexpr char hello = 'h';        ///< Process id and host name.
inline constexpr char wants_job = 'j';    ///< Empty; the worker has no job, or has finished it.
inline constexpr char wants_items = 'a';  ///< Job, size and duration [s] of the last group; results.
inline constexpr char results = 'r';      ///< Results of items.
inline constexpr char refused = 'e';      ///< Faults in the user's file.
inline constexpr char failed = 'f';       ///< Reason for giving up.
inline constexpr char died = 'd';         ///< Cause of the worker's death.
inline constexpr char alive = 'l';
inline constexpr char bye = 'b';  ///< Empty; last message of a process.

// Messages from process 0.
inline constexpr char job = 'J';    ///< Number and content of the job.
inline constexpr char items = 'I';  ///< Next group; empty after the last item of the job.
inline constexpr char end = 'E';

}  // namespace kind

/// Returns the host name; an empty string if it is unavailable.
inline const std::string& this_host() {
  static const std::string name = [] {
    std::array<char, 256> text{};
    return std::string(::gethostname(text.data(), text.size() - 1) == 0 ? text.data() : "");
  }();
  return name;
}

}  // namespace stepwire::cluster
