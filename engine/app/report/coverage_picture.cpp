#include "engine/app/report/coverage_picture.hpp"

#include <fmt/format.h>

#include "engine/view/drawing/draw.hpp"

namespace stepwire::report {

std::map<std::string, std::string> names_with_coverage(const coverage::Coverage& coverage) {
  struct Count {
    std::size_t covered = 0, all = 0;
  };
  std::map<std::string, Count> counts;
  for (const coverage::Condition& condition : coverage.conditions) {
    counts[condition.block].covered += condition.covered();
    counts[condition.block].all += condition.branches.size();
  }
  std::map<std::string, std::string> names;
  for (const auto& [block, count] : counts)
    if (count.covered < count.all)
      names[block] =
          fmt::format("{}: {} of {}", block.substr(block.rfind('.') + 1), count.covered, count.all);
  return names;
}

std::string coverage_picture(const Registry& registry, const std::string& file,
                             const coverage::Coverage& coverage) {
  diagram::Loader loader(registry);
  const drawing::DrawnFile drawn(loader, file);
  drawing::GraphOptions options;
  options.depth = 32;
  options.names = names_with_coverage(coverage);
  return drawing::draw_picture(drawn.view().graph(options));
}

}  // namespace stepwire::report
