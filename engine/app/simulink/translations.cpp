#include <algorithm>
#include <iterator>
#include <string_view>

#include "engine/app/simulink/block_writer.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {

namespace {

std::vector<Translation> all_translations() {
  std::vector<Translation> all;
  for (auto* family :
       {source_translations, sink_translations, math_translations, function_translations, table_translations,
        continuous_translations, controller_translations, discrete_translations, nonlinear_translations,
        logic_translations, routing_translations, subsystem_translations})
    for (const Translation& one : family()) all.push_back(one);
  std::ranges::sort(all, {}, [](const Translation& of) { return lower_case(of.type); });
  return all;
}

/// Returns the name of a block of a library: "Compare To Constant" of "simulink/Logic and Bit
/// Operations/Compare To Constant".
std::string library_name(const std::string& source) {
  const std::size_t slash = source.rfind('/');
  return on_one_line(slash == source.npos ? source : source.substr(slash + 1));
}

}  // namespace

const std::vector<Translation>& translations() {
  static const std::vector<Translation> all = all_translations();
  return all;
}

const Translation* translation_of(const Model& model, const Block& block) {
  std::string type = block.type;
  if (type == "Reference") type = library_name(text_of(model, block, "SourceBlock", ""));
  const auto found = std::ranges::lower_bound(translations(), lower_case(type), {},
                                              [](const Translation& of) { return lower_case(of.type); });
  if (found == translations().end() || lower_case(found->type) != lower_case(type)) return nullptr;
  const bool is_of_library = std::string_view(found->type).find(' ') != std::string_view::npos ||
                             found->type == std::string_view("Ramp") ||
                             found->type == std::string_view("Difference");
  return (block.type == "Reference") == is_of_library ? &*found : nullptr;
}

}  // namespace stepwire::simulink
