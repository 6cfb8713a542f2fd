#include "engine/app/cli/console.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "engine/base/text/characters.hpp"

namespace stepwire::cli {

namespace {

std::atomic<int> refusal = 0;  // the first reason for which output was not taken

void note_refusal() {
  int none = 0;
  refusal.compare_exchange_strong(none, errno);
}

}  // namespace

void put_data(std::string_view data) {
  if (std::fwrite(data.data(), 1, data.size(), stdout) != data.size()) note_refusal();
}

void put_text(std::string_view text) {
  put_data(text::visible_lines(text));
}

void put_trouble(std::string_view text) {
  const std::string shown = text::visible_lines(text);
  std::fwrite(shown.data(), 1, shown.size(), stderr);
}

bool finish_output() {
  if (std::fflush(stdout) != 0) note_refusal();
  if (refusal == 0) return true;
  complain("what was to be printed is lost: {}\n", std::strerror(refusal));
  return false;
}

void fill_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) [[maybe_unused]]
      const int filled = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace stepwire::cli
