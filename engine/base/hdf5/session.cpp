#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <string_view>

#include "engine/base/hdf5/handle.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::hdf5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t) && sizeof(herr_t) == sizeof(int));

namespace {

std::recursive_mutex& mutex_of_library() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// Extracts the reason from "... errno = 28, error message = 'No space left on device', ...".
std::string reason_in(std::string_view text) {
  constexpr std::string_view begin = "error message = '";
  const std::size_t at = text.find(begin);
  if (at == text.npos) return std::string(text);
  const std::string_view rest = text.substr(at + begin.size());
  return std::string(rest.substr(0, rest.find('\'')));
}

}  // namespace

Session::Session() : lock_(mutex_of_library()) {
  // Owners close their files, so the library's exit handler is off. After a failed close on a full disk that
  // handler would close the file again and access freed memory.
  [[maybe_unused]] static const herr_t once = H5dont_atexit();
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5Eclear2(H5E_DEFAULT);
}

std::string Session::complaint() {
  std::string first;
  const auto take = [](unsigned depth, const H5E_error2_t* error, void* text) -> herr_t {
    if (depth == 0 && error->desc) *static_cast<std::string*>(text) = reason_in(error->desc);
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &first);
  return first;
}

void Session::refuse(const std::string& what) {
  const std::string words = complaint();
  throw table::TableError(words.empty() ? what : fmt::format("{} ({})", what, words));
}

}  // namespace stepwire::hdf5
