#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "engine/simulate/run/observer.hpp"

namespace stepwire::session {

/// Callbacks and interruption of long operations. Callbacks may be called from any thread.
struct Monitor {
  const std::atomic<bool>* interrupt = nullptr;  ///< True: operations end early and keep their results.
  /// Receives the finished fraction, 0 to 1, and a note of a fit or a study.
  std::function<void(double fraction, const std::string& what)> progress;
  std::function<void(const std::string& text)> diagnostic;  ///< Receives notes, such as why nothing is
                                                            ///< compiled.
  std::vector<run::RunObserver*> observers;                 ///< Observers of all runs; must outlive the call.

  bool interrupted() const { return interrupt && *interrupt; }
  void show(double fraction, const std::string& what = {}) const {
    if (progress) progress(fraction, what);
  }
  /// Reports why the model was interpreted; an empty problem reports nothing.
  void note_interpreted(const std::string& problem) const {
    if (diagnostic && !problem.empty()) diagnostic("interpreted, since " + problem);
  }
};

}  // namespace stepwire::session
