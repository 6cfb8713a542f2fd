#include "engine/simulate/codegen/headers.hpp"

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "engine/base/io/surroundings.hpp"
#include "engine/simulate/codegen/compiler.hpp"

namespace stepwire {

std::string header_text(const std::string& header) {
  std::ifstream file(source_folder() + "/" + header);
  if (!file)
    throw SurroundingsError(source_folder() + "/" + header +
                            ": is not there; code is made with the headers of the blocks");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> with_included(const std::vector<std::string>& headers) {
  static const std::regex include(R"re(#include "([^"]+)")re");
  std::set<std::string> all;
  std::vector<std::string> open(headers);
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    if (!all.insert(header).second) continue;
    const std::string text = header_text(header);
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
      open.push_back((*it)[1]);
  }
  return {all.begin(), all.end()};
}

}  // namespace stepwire
