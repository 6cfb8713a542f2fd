#include "engine/app/cli/monitoring.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

constexpr int width = 32;

}  // namespace

Progress::Progress(const std::string& label)
    : label_(text::visible(label)), on_terminal_(isatty(STDERR_FILENO) == 1 && !console_style().quiet) {}

Progress::~Progress() {
  if (on_terminal_ && last_permille_ >= 0) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(double fraction, const std::string& what) {
  const std::lock_guard lock(mutex_);
  const int permille = static_cast<int>(1000.0 * std::clamp(fraction, 0.0, 1.0));
  if (!on_terminal_ || (permille == last_permille_ && what.empty())) return;
  last_permille_ = std::max(permille, last_permille_);
  const int full = width * last_permille_ / 1000;
  const std::string bar = fmt::format("\r\x1b[K{} [{:=<{}}{: <{}}] {:3} % {}", label_, "", full, "",
                                      width - full, last_permille_ / 10, text::visible(what));
  std::fputs(bar.c_str(), stderr);
  std::fflush(stderr);
}

session::Monitor terminal_monitor(Progress* progress) {
  session::Monitor monitor;
  monitor.interrupt = &interrupted();
  monitor.diagnostic = [](const std::string& text) { remark("{}\n", text); };
  if (progress)
    monitor.progress = [progress](double fraction, const std::string& what) {
      progress->show(fraction, what);
    };
  return monitor;
}

}  // namespace stepwire::cli
