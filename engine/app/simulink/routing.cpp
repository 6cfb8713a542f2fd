// Wires of Simulink that join, part and choose signals.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/app/simulink/forms.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

void mux(BlockWriter& write) {
  int count = write.inputs();
  if (write.is_written("Inputs") && write.block().type == "Mux") {
    const Value inputs = write.value("Inputs", "");
    count = std::max(count, inputs.is_scalar() ? static_cast<int>(inputs.number())
                                               : static_cast<int>(inputs.cells.size()));
  }
  std::vector<yaml::Node> sources;
  for (int i = 1; i <= std::min(count, 1000); ++i) sources.push_back(word(write.source(i)));
  write.make("Mux").key("u", list_of(std::move(sources)));
}

/// Returns the sizes of the pieces of a Demux.
std::vector<std::size_t> sizes_of(const BlockWriter& write) {
  const Value outputs = write.value("Outputs", "4");
  std::vector<std::size_t> sizes;
  if (!outputs.is_scalar()) {
    for (const double size : outputs.numbers()) {
      if (!(size >= 1.0 && size <= 1e6)) throw Untranslated("a size of its outputs is not given");
      sizes.push_back(static_cast<std::size_t>(size));
    }
    return sizes;
  }
  const double count = outputs.number();
  if (!(count >= 1.0 && count <= 1000.0))
    throw Untranslated("its number of outputs is " + write.text("Outputs"));
  const auto pieces = static_cast<std::size_t>(count);
  const std::size_t width = write.width(1);
  sizes.assign(pieces, width > pieces ? width / pieces : 1);
  for (std::size_t i = 0; width > pieces && i < width % pieces; ++i) ++sizes[i];
  return sizes;
}

void demux(BlockWriter& write) {
  const std::string source = write.source();
  std::size_t first = 1;
  int port = 0;
  for (const std::size_t size : sizes_of(write)) {
    ++port;
    if (size == 1) {
      write.output(port, source == "0" ? source : fmt::format("{}.{}", source, first));
    } else {
      Value indices = Value::matrix(1, size, 0.0);
      for (std::size_t i = 0; i < size; ++i) indices.cells[i].number = static_cast<double>(first + i);
      write.output(port,
                   write.extra(std::to_string(port),
                               block_node("Select", {{"u", word(source)}, {"indices", list_node(indices)}})));
    }
    first += size;
  }
}

/// Returns the names of the fields of a bus: those in the block, of the signals, or signal1, signal2, ...
std::vector<std::string> field_names(const BlockWriter& write) {
  std::vector<std::string> names;
  for (int i = 1; i <= write.inputs(); ++i) {
    const std::string signal = write.signal_name(i);
    names.push_back(signal.empty() ? fmt::format("signal{}", i) : valid_name(signal));
  }
  return names;
}

void bus_creator(BlockWriter& write) {
  const std::vector<std::string> names = field_names(write);
  yaml::Node fields = map_of({});
  for (std::size_t i = 0; i < names.size(); ++i)
    add(fields, names[i], word(write.source(static_cast<int>(i + 1))));
  write.make_fields(std::move(fields));
}

void bus_selector(BlockWriter& write) {
  if (write.is_on("OutputAsBus")) throw Untranslated("its output is a bus of chosen signals");
  int port = 0;
  for (const std::string& path : parts_of(write.text("OutputSignals"), ',')) {
    std::string field;
    for (const std::string& part : parts_of(path, '.')) field += "." + valid_name(part);
    write.output(++port, write.source() + field);
  }
}

Value shifted(const BlockWriter& write, Value indices) {
  const double first = write.text("IndexMode", "One-based") == "Zero-based" ? 1.0 : 0.0;
  for (const double index : indices.numbers())
    if (index != std::round(index)) throw Untranslated("its indices are no whole numbers");
  return first == 0.0 ? indices : each('+', indices, Value::of(first));
}

void selector(BlockWriter& write) {
  require(write, "NumberOfDimensions", "1");
  const std::string option =
      write.text("IndexOptionArray", write.text("IndexOptions", "Index vector (dialog)"));
  if (option == "Select all") return write.output(1, write.source());
  if (option != "Index vector (dialog)") throw Untranslated("its indices are: " + option);
  const char* name = !write.text("IndexParamArray").empty() ? "IndexParamArray"
                     : !write.text("Indices").empty()       ? "Indices"
                                                            : "Elements";
  write.make("Select").u().key("indices", list_node(shifted(write, write.finite(name, "[1 3]"))));
}

void concatenate(BlockWriter& write) {
  if (write.text("Mode", "Vector") == "Vector") return mux(write);
  const std::string dimension = write.text("ConcatenateDimension", "1");
  if (dimension != "1" && dimension != "2")
    throw Untranslated("it concatenates along dimension " + dimension);
  write.make(dimension == "1" ? "Stack" : "Concatenate").key("u", list_of(write.sources()));
}

void reshape(BlockWriter& write) {
  const std::string kind = write.text("OutputDimensionality", "1-D array");
  const std::size_t width = write.width(1);
  std::size_t rows = width, columns = 1;
  if (kind == "Customize") {
    const std::vector<double> sizes = write.finite("OutputDimensions", "[1,1]").numbers();
    if (sizes.size() > 2) throw Untranslated("its output has more than two dimensions");
    rows = static_cast<std::size_t>(sizes[0]);
    columns = sizes.size() > 1 ? static_cast<std::size_t>(sizes[1]) : 1;
  } else if (width == 0) {
    throw Untranslated("its number of elements does not follow from the file");
  } else if (kind.starts_with("Row")) {
    std::swap(rows, columns);
  }
  write.make("Reshape").u().key("rows", std::to_string(rows)).key("columns", std::to_string(columns));
}

void passes(BlockWriter& write) {
  write.output(1, write.source());
}

void conversion(BlockWriter& write) {
  const std::string type = write.text("OutDataTypeStr", write.text("OutDataTypeMode", "Inherit"));
  if (type == "boolean") {
    expression(write, "u1 != 0", {word(write.source())});
    return;
  }
  passes(write);
  if (type != "double" && !type.starts_with("Inherit"))
    write.deviates(fmt::format("converts to {} in Simulink, and passes its signal on here", type));
}

/// True where a block leads to initial values of integrators alone, which take its value.
bool leads_to_initial_values(const BlockWriter& write) {
  const Instance& in = write.instance();
  std::size_t count = 0;
  for (const auto& [port, source] : in.sources) {
    const auto from = in.by_sid.find(source.sid);
    if (from == in.by_sid.end() || from->second != &write.block()) continue;
    const auto sink = in.by_sid.find(port.substr(0, port.rfind('#')));
    if (sink == in.by_sid.end()) return false;
    const Block& block = *sink->second;
    const bool is_integrator = block.type == "Integrator" || block.type == "DiscreteIntegrator";
    const int input = initial_input(write.model().model(), block);
    if (!is_integrator || input == 0 || !port.ends_with(fmt::format("#in:{}", input))) return false;
    ++count;
  }
  return count > 0;
}

void initial_condition(BlockWriter& write) {
  write.output(1, write.source());
  if (leads_to_initial_values(write)) return;
  write.deviates("shows its value at the first step in Simulink, and its input here");
}

void constraint(BlockWriter& write) {
  const std::string sum =
      write.extra("sum", block_node("Sum", {{"u", list_of({word(write.name()), word(write.source())})}}));
  write.make("InitialGuess").key("u", sum).key("guess", "InitialGuess", "0");
}

}  // namespace

std::vector<Translation> routing_translations() {
  return {{"Mux", "`Mux`", mux},
          {"Demux", "elements, `v.2`, or `Select`", demux},
          {"BusCreator", "a bus: `{fields: {..}}`", bus_creator},
          {"BusSelector", "a field: `bus.force`", bus_selector},
          {"Selector", "`Select`", selector},
          {"Concatenate", "`Mux`, `Stack`, `Concatenate`", concatenate},
          {"Reshape", "`Reshape`", reshape},
          {"SignalConversion", "nothing: the wire itself", passes},
          {"SignalSpecification", "nothing: the wire itself", passes},
          {"DataTypeConversion", "nothing, or `Expression` for truths", conversion},
          {"InitialCondition", "the wire itself, and a note; before an initial value its `initial`",
           initial_condition},
          {"AlgebraicConstraint", "`InitialGuess` behind a `Sum`", constraint}};
}

}  // namespace stepwire::simulink
