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

/// Parses "interpreted" or "compiled"; any other text is automatic.
run::ExecutionMode mode_of(const std::string& engine);

/// Call of a session from Python, with Python observers and progress. The interpreter lock is released during
/// the call.
class SessionCall {
 public:
  /// `observers` is a list. `progress` is called with the finished fraction and the current activity. Either
  /// may be nullptr or None. The caller must hold the interpreter lock here and in make().
  SessionCall(File of, _object* observers, _object* progress);

  /// Throws the exceptions of the session.
  void make(const std::function<void(session::Session&)>& act);
  const std::vector<std::string>& notes() const { return notes_; }
  /// Return the first exception of observers, progress or signal handlers, and that of blocks; nullptr if
  /// none.
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
