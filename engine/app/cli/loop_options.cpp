#include "engine/app/cli/loop_options.hpp"

#include <CLI/CLI.hpp>

namespace stepwire::cli {

std::vector<CLI::Option*> add_timing_options(CLI::App& verb, session::LoopWords& words) {
  return {verb.add_option("--rate", words.rate, "how often the thread wakes [Hz]")->capture_default_str(),
          verb.add_option("--policy", words.policy, "how it is scheduled: fifo:1 to fifo:99, or other")
              ->capture_default_str(),
          verb.add_option("--cpu", words.cpu, "the processor to which it is bound"),
          verb.add_option("--overrun", words.overrun,
                          "what a missed deadline means: skip drops it, catch-up runs it late, stop:N ends "
                          "the loop after N in a row")
              ->capture_default_str(),
          verb.add_option("--spin", words.spin, "time before each deadline at which it is awake, e.g. 200us")
              ->capture_default_str()};
}

}  // namespace stepwire::cli
