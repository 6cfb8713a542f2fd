#include "engine/view/render/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {
namespace {

/// File in memory that a child process may open by its path; it disappears with this process.
class ScriptFile {
 public:
  explicit ScriptFile(std::string_view text) : number_(::memfd_create("script", MFD_CLOEXEC)) {
    while (number_ >= 0 && !text.empty()) {
      const ssize_t count = ::write(number_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    if (!text.empty()) {
      const std::string reason = std::strerror(errno);
      if (number_ >= 0) ::close(number_);
      throw io::EnvironmentError("there is no memory for a picture: " + reason);
    }
  }
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;
  ~ScriptFile() { ::close(number_); }

  std::string path() const { return fmt::format("/proc/{}/fd/{}", ::getpid(), number_); }

 private:
  int number_;
};

}  // namespace

bool has_gnuplot() {
  return !subprocess::find_program("gnuplot").empty();
}

GnuplotAnswer run_gnuplot(const std::string& script) {
  const std::string program = subprocess::find_program("gnuplot");
  if (program.empty())
    throw io::EnvironmentError("gnuplot is not installed; on Debian it is the package gnuplot-nox");
  // gnuplot reads its standard input byte by byte, with a system call for each.
  const ScriptFile file(script);
  subprocess::ProcessResult result = subprocess::run_process({.command = {program, "-d", file.path()}});
  text::replace_all(result.errors, file.path(), "script");
  if (result.end == subprocess::ProcessResult::End::stopped)
    throw subprocess::ProcessStopped("gnuplot was stopped");
  if (!result.succeeded()) throw io::EnvironmentError("gnuplot failed: " + result.problem("gnuplot"));
  return {std::move(result.output), std::move(result.errors)};
}

}  // namespace stepwire::render
