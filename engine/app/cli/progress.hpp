#pragma once

#include <mutex>
#include <string>

namespace stepwire::cli {

/// A bar on the standard error while something takes long; silent where that is no terminal.
class Progress {
 public:
  explicit Progress(const std::string& label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` 0 to 1; may be called from any thread.
  void show(double fraction, const std::string& what = "");

 private:
  std::string label_;
  bool on_terminal_;
  int last_permille_ = -1;
  std::mutex mutex_;
};

}  // namespace stepwire::cli
