#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/python/loaded_file.hpp"
#include "engine/app/python/observing.hpp"
#include "engine/app/python/results.hpp"
#include "engine/stepwire/shown.hpp"

namespace stepwire::python {

/// "interpreted", "compiled", or anything else for automatic.
run::ExecutionMode mode_of(const std::string& engine);

/// One call of a session from Python: observers and progress are Python's, the interpreter lock is released.
class SessionCall {
 public:
  /// `observers` is a list, `progress` is called with the fraction done and what goes on; either may be null
  /// or None. The lock is held for this and for make().
  SessionCall(File of, _object* observers, _object* progress);

  /// Throws what the session throws.
  void make(const std::function<void(session::Session&)>& act);
  const std::vector<std::string>& notes() const { return notes_; }
  /// What observers, progress and signals raised, and what blocks did: null where nothing was raised.
  Held take_raised() { return raised_.take(); }
  Held take_cause() { return file_->kinds()->raised->take(); }
  void throw_if_raised() { raised_.throw_if_any(); }

 private:
  void watch(session::Monitor& monitor, std::atomic<bool>& interrupt);
  void show(double fraction, const std::string& what, std::atomic<bool>& interrupt);

  File file_;
  Model model_;
  Raised raised_;
  _object* progress_;
  std::vector<std::unique_ptr<PythonObserver>> observers_;
  std::vector<std::unique_ptr<Shown>> shown_;
  std::mutex mutex_;
  std::vector<std::string> notes_;
};

}  // namespace stepwire::python
