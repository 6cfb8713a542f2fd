#include "engine/app/cli/monitoring.hpp"

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"

namespace stepwire::cli {

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
