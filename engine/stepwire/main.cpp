// Build tool that writes the headers which are installed: main SOURCES OUT HEADER... takes the public headers
// in an order in which each includes only those before it. An internal header becomes a part of the first
// public header that needs it; the later ones include that one. Thus the package has no other header
// of this library.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

class PublicHeaders {
 public:
  explicit PublicHeaders(fs::path sources) : sources_(std::move(sources)) {}

  /// Returns the text of a public header, "model.hpp", with the internal headers that no earlier one has.
  std::string text_of(const std::string& header) {
    current_ = header;
    includes_ = {header};
    std::string text = "#pragma once\n";
    append("engine/stepwire/" + header, text);
    done_.insert(header);
    return text;
  }

 private:
  void append(const std::string& file, std::string& text) {
    std::ifstream stream(sources_ / file);
    if (!stream) throw std::runtime_error(file + " cannot be read");
    static const std::regex include(R"re(#include ["<](engine/|stepwire/)([^">]+)[">].*)re");
    for (std::string line; std::getline(stream, line);) {
      std::smatch found;
      if (line == "#pragma once") continue;
      if (!std::regex_match(line, found, include))
        text += line + "\n";
      else if (found[1] == "engine/" && !found[2].str().starts_with("stepwire/"))
        take("engine/" + found[2].str(), text);
      else
        refer(fs::path(found[2].str()).filename(), text);
    }
  }

  /// Includes the public header that has an internal one, or makes it a part of this one.
  void take(const std::string& internal, std::string& text) {
    const auto [at, is_new] = homes_.emplace(internal, current_);
    if (is_new)
      append(internal, text);
    else
      refer(at->second, text);
  }

  void refer(const std::string& header, std::string& text) {
    if (!includes_.insert(header).second) return;
    if (!done_.contains(header)) throw std::runtime_error(current_ + " comes before " + header);
    text += "#include <stepwire/" + header + ">\n";
  }

  fs::path sources_;
  std::string current_;
  std::set<std::string> includes_, done_;     ///< those of the current header; those that are written
  std::map<std::string, std::string> homes_;  ///< public header by internal one
};

}  // namespace

int main(int count, char** arguments) try {
  if (count < 3) return 2;
  PublicHeaders headers(arguments[1]);
  const fs::path out = arguments[2];
  fs::create_directories(out);
  for (int i = 3; i < count; ++i)
    if (!(std::ofstream(out / arguments[i]) << headers.text_of(arguments[i])).flush())
      throw std::runtime_error((out / arguments[i]).string() + " cannot be written");
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
