#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace stepwire::codegen {

/// C++ compiler of this machine.
class Compiler {
 public:
  /// Finds the compiler of the environment variable CXX, else the first installed one of c++, g++ and
  /// clang++.
  Compiler();

  bool found() const { return !path_.empty(); }
  /// Returns the reason why no compiler was found.
  const std::string& problem() const { return problem_; }
  /// Returns name and version, as the compiler prints them.
  const std::string& version() const { return version_; }
  bool is_gcc() const;
  /// Returns the flags of generated code. They give the bits of the interpreter: no contraction of multiply
  /// and add, and functions such as sin are never evaluated by the compiler.
  static std::vector<std::string> flags();

  /// Flags for GCC alone, of passes that cost time or speed in generated code. The first two find little in
  /// straight-line code, and the time of the first one grows quadratically. The third one changes the
  /// arguments of a block's loops before they are inlined, and then calls remain: W1 takes 2.3 times as long.
  static constexpr const char* gcc_flags[] = {"-fno-tree-pta", "-fno-tree-slp-vectorize", "-fno-ipa-sra"};

  /// Library of the functions of elementary.hpp. The program needs it, too, so that it is on each machine.
  static constexpr const char* elementary_functions = "libsleef.so.3";

  /// Flag that enables all instructions of this machine's processor.
  static constexpr const char* native = "-march=native";

  /// Compiles a source, which may include the headers of stepwire, into a shared library, with further flags.
  /// Returns an empty text after success, else the compiler's messages. A stop ends the compiler, without a
  /// library. Throws EnvironmentError if the headers are missing.
  std::string compile(const std::string& source, const std::string& library,
                      const std::vector<std::string>& more, const std::stop_token& stop) const;

  /// Precompiles the standard headers that blocks include into a folder, for sources compiled with these
  /// further flags. compile() uses those in the folder of this build. Without them, reading these headers
  /// takes half of the compile time of a usual diagram. Returns an empty text after success, else the
  /// compiler's messages.
  std::string precompile(const std::string& folder, const std::vector<std::string>& more) const;

 private:
  std::vector<std::string> command(const std::vector<std::string>& more) const;

  std::string path_, version_;
  std::string problem_ = "no C++ compiler is there (c++, g++ or clang++, or what CXX names)";
};

}  // namespace stepwire::codegen
