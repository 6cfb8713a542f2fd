#pragma once

#include <csignal>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/engine/base/table/scratch.hpp"

/// A call of the program: its arguments, environment and limits, and the signals that it gets.
struct Call {
  std::vector<std::string> arguments;
  std::map<std::string, std::optional<std::string>>
      environment;                                   ///< set, or taken away where there is no value
  std::optional<unsigned long> max_bytes_of_file{};  ///< a disk that is full beyond
  std::optional<double> interrupt_after{};           ///< [s]; by these signals, one at once behind the other
  std::vector<int> signals{SIGINT};
  std::string interrupt_when{};    ///< file at whose creation the signals are sent; replaces interrupt_after
  std::string out_to{}, err_to{};  ///< files for standard output and error; files of ours if empty
  std::vector<int> closed{};       ///< closed streams
  bool closed_pipe = false;        ///< standard output is a pipe without reader
  bool no_threads = false;         ///< threads cannot start
};

/// Result of a call.
struct Done {
  int code = -1;  ///< exit status; 128 + signal where one ended it
  std::string out, err;
  double seconds = 0.0;
  double megabytes = 0.0;  ///< of memory at most
};

/// Runs the built program in a folder.
Done run_program(const Scratch& folder, const Call& call);
Done run_program(const Scratch& folder, const std::vector<std::string>& arguments);

/// Lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);
/// All of a file; empty if it is not there.
std::string content_of(const std::string& path);

/// A lag that follows a step, with a parameter, a record and a claim that holds.
extern const std::string lag_yaml;
/// A diagram whose run takes minutes.
extern const std::string endless_yaml;
