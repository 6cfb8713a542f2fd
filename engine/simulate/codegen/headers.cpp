#include "engine/simulate/codegen/headers.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "engine/base/io/surroundings.hpp"
#include "engine/model/diagram/external_input.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/solve/solver.hpp"

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

void require_headers(const Plan& plan) {
  Faults faults;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const DiagramBlock& block = plan.diagram.blocks[b];
    const BlockType& type = block.type();
    const char* why = type.file_output ? "it writes files"
                      : type.header.empty() && &type != &external_input_type()
                          ? "its type is not one of the library"
                          : nullptr;
    if (why)
      faults.add(plan.diagram.fault(block.origin, block.name,
                                    fmt::format("{} cannot be generated: {}", type.name, why)));
  }
  faults.throw_if_any();
}

std::vector<std::string> headers_of(const Plan& plan) {
  std::set<std::string> headers;
  for (const DiagramBlock& block : plan.diagram.blocks)
    if (!block.type().header.empty()) headers.insert(block.type().header);
  if (const auto method = find_implicit(plan.diagram.solver)) headers.insert(method->header);
  if (plan.diagram.stop_when) headers.insert(language_header);
  headers.insert("engine/model/block/block.hpp");
  return {headers.begin(), headers.end()};
}

}  // namespace stepwire
