#pragma once

#include <stop_token>
#include <string>

#include "engine/base/io/cache.hpp"
#include "engine/simulate/device/kernel_text.hpp"

namespace stepwire::device {

/// Compiler of kernels: clang, with its code generator for NVIDIA's PTX.
class PtxCompiler {
 public:
  /// Finds clang++-22 to clang++-18 or clang++, the first that is installed.
  explicit PtxCompiler(io::Cache cache = io::Cache());

  bool found() const { return !path_.empty(); }
  /// Returns the reason why no compiler was found.
  const std::string& problem() const { return problem_; }

  /// Returns the PTX of a kernel, from the cache or compiled. On failure returns an empty text, with the
  /// reason in `why`; the reason is empty after a stop.
  std::string compile(const KernelText& kernel, const std::stop_token& stop, std::string& why) const;

 private:
  std::string made(const KernelText& kernel, const std::stop_token& stop, std::string& why) const;

  io::Cache cache_;
  std::string path_, version_, problem_;
};

/// Returns the name of a function that PTX calls and no device has; an empty text without one.
std::string unresolved_call(const std::string& ptx);

}  // namespace stepwire::device
