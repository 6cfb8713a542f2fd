#pragma once

#include <stop_token>
#include <string>

#include "engine/generate/compiler.hpp"
#include "engine/generate/program.hpp"
#include "engine/plan/compiled_plan.hpp"

namespace stepwire {

/// Flags for code with these headers that only this machine will run. Eigen adds in an order that depends on
/// the processor it is compiled for, and the interpreter is compiled for any: only code without it gives the
/// same bits when it is compiled for this one.
std::vector<std::string> flags_for_this_machine(const std::vector<std::string>& headers);

/// The source of a shared library with a program's functions.
std::string library_source(const GeneratedProgram& program);

/// A folder that keeps compiled programs, so that the same diagram is compiled once. Several processes may
/// use it at a time: a library appears whole or not at all. The least recently used ones go when there are
/// too many.
class CodeCache {
 public:
  /// In cache_folder().
  CodeCache();
  explicit CodeCache(std::string folder, std::uintmax_t most_bytes = 256u << 20u)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// The functions of a program, from the cache or compiled; they stay loaded. On failure they are null and
  /// `problem` says why.
  StepFunctions load(const GeneratedProgram& program, const Compiler& compiler, const std::stop_token& stop,
                     std::string& problem) const;

 private:
  std::string key(const std::string& source, const GeneratedProgram& program, const Compiler& compiler) const;
  bool make(const std::string& source, const std::string& library, const std::vector<std::string>& flags,
            const Compiler& compiler, const std::stop_token& stop, std::string& problem) const;
  void drop_old() const;

  std::string folder_;
  std::uintmax_t most_bytes_;
};

}  // namespace stepwire
