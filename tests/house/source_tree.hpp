#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// One line of a file, with its place for messages; lines are counted from 1.
struct Line {
  std::string file;  ///< path from the top of the source tree
  int number = 0;
  std::string text;
  std::string place() const { return file + ":" + std::to_string(number); }
};

/// Paths of all files under a folder of the source tree ("" for all of it), from its top; build output left
/// out.
std::vector<std::string> files_under(const std::string& folder);

/// The lines of a file; none if it is no text.
std::vector<Line> lines_of(const std::string& file);

/// The sources in C++ of the folders.
std::vector<std::string> sources_under(const std::vector<std::string>& folders);

/// The sources of the folders in all languages: C++, TypeScript, JavaScript modules and Python.
std::vector<std::string> all_sources_under(const std::vector<std::string>& folders);

/// The folder of a file: "engine/model/plan" of "engine/model/plan/order.cpp".
std::string folder_of(const std::string& file);
