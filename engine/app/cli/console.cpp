#include "engine/app/cli/console.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "engine/app/cli/console_style.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {

namespace {

std::atomic<int> refusal = 0;  // errno of the first failed write

void note_refusal() {
  int none = 0;
  refusal.compare_exchange_strong(none, errno);
}

std::string shown(std::string_view text, int stream) {
  std::string plain = text::visible_lines(text);
  return has_colors(stream) ? painted(plain) : plain;
}

}  // namespace

void put_data(std::string_view data) {
  if (std::fwrite(data.data(), 1, data.size(), stdout) != data.size()) note_refusal();
}

void put_text(std::string_view text) {
  if (!console_style().quiet) put_failure(text);
}

void put_failure(std::string_view text) {
  if (console_style().data_only) return put_trouble(text);
  put_data(shown(text, STDOUT_FILENO));
}

void put_trouble(std::string_view text) {
  const std::string all = shown(text, STDERR_FILENO);
  std::fwrite(all.data(), 1, all.size(), stderr);
}

void put_note(std::string_view text) {
  if (!console_style().quiet) put_trouble(text);
}

bool finish_output() {
  if (std::fflush(stdout) != 0) note_refusal();
  if (refusal == 0 || refusal == EPIPE) return true;
  complain("what was to be printed is lost: {}\n", std::strerror(refusal));
  return false;
}

void fill_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) [[maybe_unused]]
      const int filled = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace stepwire::cli
