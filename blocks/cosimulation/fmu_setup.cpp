#include "blocks/cosimulation/fmu_setup.hpp"

#include <algorithm>

#include "engine/base/fmi/assignments.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

namespace {

/// Returns the texts of a value of the map, one number or a list.
std::vector<std::string> texts_of(const Value& value, const Configure& is) {
  std::vector<std::string> texts;
  if (value.text()) texts.push_back(*value.text());
  if (value.list())
    for (const Value& item : *value.list()) {
      if (!item.text()) is.refuse<&Fmu::parameters>("a value is a number or a list of numbers", item);
      texts.push_back(*item.text());
    }
  if (texts.empty()) is.refuse<&Fmu::parameters>("a value is a number or a list of numbers", value);
  return texts;
}

std::vector<fmi::Assignment> assignments_of(const Fmu& block, const fmi::Description& description,
                                            const Configure& is) {
  std::vector<fmi::Assignment> assignments;
  const Value tree = block.parameters.value();
  if (!tree.map() && tree.line > 0)
    is.refuse<&Fmu::parameters>("must be a map of names and values: {k: 2 1/s}", tree);
  if (!tree.map()) return assignments;
  for (const auto& [name, value] : *tree.map()) {
    auto read = fmi::read_assignment(description, name, texts_of(value, is));
    if (!read.wrong.empty()) is.refuse<&Fmu::parameters>(read.wrong.text(), value);
    assignments.push_back(std::move(read.assignment));
  }
  return assignments;
}

}  // namespace

void configure_unit(Fmu& block, Configure& is, fmi::Mode mode) {
  try {
    fmi::Setup setup{fmi::open_package(block.file.string()), mode, is.name().empty() ? "unit" : is.name()};
    setup.assignments = assignments_of(block, setup.package->description(), is);
    if (setup.package->description().smooth) is.smooth();
    block.unit.prepare(std::move(setup), block.isolate);
  } catch (const fmi::UnitError& error) {
    is.refuse<&Fmu::file>(error.what());
  }
  is.size("k", static_cast<Index>(std::max<std::size_t>(block.unit.kept(), 1)));
}

}  // namespace stepwire
