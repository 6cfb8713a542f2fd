#include "engine/app/cli/console.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

constexpr std::string_view plain = "\x1b[0m", bold = "\x1b[1m", red = "\x1b[1;31m", green = "\x1b[32m",
                           yellow = "\x1b[33m";

/// Start of a line, and its part that is coloured.
struct Beginning {
  std::string_view before, word, color;
};
constexpr std::array<Beginning, 8> beginnings{{{"  ", "FAIL ", red},
                                               {"  ", "ok   ", green},
                                               {"  ", "note ", yellow},
                                               {"", "note: ", yellow},
                                               {"    ", "+ ", green},
                                               {"    ", "- ", red},
                                               {"    ", "~ ", yellow},
                                               {"    ", "> ", yellow}}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Returns the length of a location such as "file.yaml:10:48:" at the start of a line; 0 without one.
std::size_t length_of_place(std::string_view line) {
  for (std::size_t colon = line.find(':'); colon != line.npos; colon = line.find(':', colon + 1)) {
    std::size_t at = colon;
    int numbers = 0;
    while (numbers < 2 && at + 1 < line.size() && line[at] == ':' && is_digit(line[at + 1])) {
      at = std::min(line.find_first_not_of("0123456789", at + 1), line.size());
      ++numbers;
    }
    if (numbers == 2 && at < line.size() && line[at] == ':') return at + 1;
  }
  return 0;
}

void append_colored(std::string& text, std::string_view part, std::string_view color) {
  text.append(color).append(part).append(plain);
}

void append_painted(std::string& text, std::string_view line) {
  for (const Beginning& known : beginnings) {
    if (!line.starts_with(known.before) || !line.substr(known.before.size()).starts_with(known.word))
      continue;
    text += known.before;
    append_colored(text, known.word, known.color);
    text += line.substr(known.before.size() + known.word.size());
    return;
  }
  const std::size_t place = length_of_place(line);
  if (place > 0) append_colored(text, line.substr(0, place), bold);
  text += line.substr(place);
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

std::atomic<int> refusal = 0;  // errno of the first failed write

void note_refusal() {
  int none = 0;
  refusal.compare_exchange_strong(none, errno);
}

/// True if output to a stream (STDOUT_FILENO, STDERR_FILENO) is coloured.
bool has_colors(int stream) {
  const Color color = console_style().color;
  if (color != Color::automatic) return color == Color::always;
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal && std::string_view(terminal) == "dumb";
  const bool forwarded = is_set("PMIX_RANK");  // mpirun connects its processes to terminals of its own
  return !is_set("NO_COLOR") && !dumb && !forwarded && ::isatty(stream) == 1;
}

/// Colours the starts of lines that are verdicts, notes, or errors with a location. The text must have whole
/// lines.
std::string painted(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    append_painted(result, std::string_view(text).substr(at, end - at));
    at = end;
  }
  return result;
}

std::string shown(std::string_view text, int stream) {
  std::string plain = text::visible_lines(text);
  return has_colors(stream) ? painted(plain) : plain;
}

}  // namespace

ConsoleStyle& console_style() {
  static ConsoleStyle style;
  return style;
}

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

std::size_t read_standard_input(char* to, std::size_t most) {
  ssize_t count = 0;
  do count = ::read(STDIN_FILENO, to, most);
  while (count < 0 && errno == EINTR);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void fill_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) [[maybe_unused]]
      const int filled = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace stepwire::cli
