#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "engine/simulate/run/observer.hpp"

namespace stepwire::session {

/// How a door watches what takes long, and ends it. Calls come from any thread.
struct Monitor {
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, what goes on ends and keeps what it has
  /// The fraction done, 0 to 1, and what a fit or a study says of it.
  std::function<void(double fraction, const std::string& what)> progress;
  std::function<void(const std::string& text)> diagnostic;  ///< such as why nothing is compiled
  std::vector<run::RunObserver*> observers;                 ///< of every run and trial; must outlive the call

  bool interrupted() const { return interrupt && *interrupt; }
  void show(double fraction, const std::string& what = {}) const {
    if (progress) progress(fraction, what);
  }
  /// Nothing where there was no problem.
  void note_interpreted(const std::string& problem) const {
    if (diagnostic && !problem.empty()) diagnostic("interpreted, since " + problem);
  }
};

}  // namespace stepwire::session
