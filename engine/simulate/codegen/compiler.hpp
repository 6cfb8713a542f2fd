#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace stepwire::codegen {

/// A C++ compiler of this machine.
class Compiler {
 public:
  /// What the environment variable CXX names, else the first of c++, g++ and clang++ that is there.
  Compiler();

  bool found() const { return !path_.empty(); }
  /// Why there is none.
  const std::string& problem() const { return problem_; }
  /// Name and version, as the compiler tells them.
  const std::string& version() const { return version_; }
  bool is_gcc() const;
  /// How generated code is compiled: the same bits as the interpreter, so no contraction of multiply and add,
  /// and functions such as sin only ever computed by the library, never by the compiler.
  static std::vector<std::string> flags();

  /// Lets the compiler use all that this machine's processor has.
  static constexpr const char* native = "-march=native";

  /// Compiles a source, which may include our headers, into a shared library, with further flags. Empty if
  /// that went well, else what the compiler said. A stop ends the compiler, and there is no library then.
  /// Throws EnvironmentError where our headers are not there.
  std::string compile(const std::string& source, const std::string& library,
                      const std::vector<std::string>& more, const std::stop_token& stop) const;

  /// Precompiles the standard headers that blocks include, for sources compiled with these further flags,
  /// into a folder. What lies in that of this build is used by compile(). Reading those headers takes as long
  /// as compiling what a diagram of usual size adds to them. Empty if that went well, else what the compiler
  /// said.
  std::string precompile(const std::string& folder, const std::vector<std::string>& more) const;

 private:
  std::vector<std::string> command(const std::vector<std::string>& more) const;

  std::string path_, version_;
  std::string problem_ = "no C++ compiler is there (c++, g++ or clang++, or what CXX names)";
};

}  // namespace stepwire::codegen
