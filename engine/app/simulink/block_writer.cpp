#include "engine/app/simulink/block_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {

BlockWriter::BlockWriter(FlatModel& model, std::size_t index, Collected& collected, std::vector<Note>& notes)
    : model_(model),
      flat_(model.blocks()[index]),
      block_(*flat_.block),
      collected_(collected),
      notes_(notes) {}

std::string BlockWriter::text(const std::string& name, const std::string& otherwise) const {
  return text_of(model_.model(), block_, name, otherwise);
}

void BlockWriter::say_default(const std::string& name, const std::string& otherwise) const {
  if (!is_written(name))
    note(fmt::format("its {} is not in the file; {}, the default of Simulink, is written", name, otherwise));
}

Value BlockWriter::undecided(const std::string& name) const {
  return is_written(name) ? finite(name, "")
                          : model_.evaluate(*flat_.in, valid_name(block_.name) + "_" + name);
}

Value BlockWriter::value(const std::string& name, const std::string& otherwise) const {
  const std::string written = text(name, otherwise);
  try {
    return model_.evaluate(*flat_.in, written);
  } catch (const ValueError& error) {
    throw Untranslated(
        fmt::format("its parameter {}, '{}', {}", name, on_one_line(written).substr(0, 100), error.what()));
  }
}

Cell BlockWriter::number(const std::string& name, const std::string& otherwise) const {
  const Value found = value(name, otherwise);
  if (!found.is_scalar())
    throw Untranslated(fmt::format("its parameter {} is {} x {}, and one number is expected", name,
                                   found.rows, found.columns));
  return found.cells[0];
}

double BlockWriter::known(const std::string& name, const std::string& otherwise) const {
  const Cell cell = number(name, otherwise);
  if (std::isnan(cell.number))
    throw Untranslated(fmt::format("its parameter {} needs the number of '{}', which is not in the file",
                                   name, cell.formula()));
  return cell.number;
}

std::string BlockWriter::source(const std::string& port) const {
  return model_.source(*flat_.in, block_, port);
}

bool BlockWriter::is_connected(int input) const {
  return model_.is_connected(*flat_.in, block_, "in:" + std::to_string(input));
}

int BlockWriter::inputs() const {
  return model_.inputs_of(*flat_.in, block_);
}

int BlockWriter::outputs() const {
  return model_.outputs_of(*flat_.in, block_);
}

int BlockWriter::written_outputs() const {
  return model_.written_outputs_of(block_);
}

std::vector<yaml::Node> BlockWriter::sources() const {
  std::vector<yaml::Node> all;
  for (int i = 1; i <= inputs(); ++i) all.push_back(word(source(i)));
  return all;
}

BlockWriter& BlockWriter::make(const std::string& type) {
  main_ = flat_.made.size();
  flat_.made.emplace_back(flat_.name, map_of({{"block", word(type)}}));
  return *this;
}

BlockWriter& BlockWriter::make_part(const std::string& file) {
  main_ = flat_.made.size();
  flat_.made.emplace_back(flat_.name, map_of({{"diagram", word(file)}}));
  return *this;
}

void BlockWriter::make_fields(yaml::Node fields) {
  flat_.made.emplace_back(flat_.name, map_of({{"fields", std::move(fields)}}));
}

BlockWriter& BlockWriter::key(const std::string& name, yaml::Node node) {
  add(flat_.made.at(main_).second, name, std::move(node));
  return *this;
}

Value BlockWriter::finite(const std::string& parameter, const std::string& otherwise) const {
  const Value found = value(parameter, otherwise);
  for (const Cell& cell : found.cells)
    if (std::isinf(cell.number)) throw Untranslated(fmt::format("its parameter {} is infinite", parameter));
  if (found.cells.empty()) throw Untranslated(fmt::format("its parameter {} is empty", parameter));
  return found;
}

BlockWriter& BlockWriter::limit(const std::string& name, const std::string& parameter,
                                const std::string& otherwise) {
  const Value found = value(parameter, otherwise);
  const bool is_none =
      std::ranges::all_of(found.cells, [](const Cell& cell) { return std::isinf(cell.number); });
  return is_none ? *this : key(name, finite(parameter, otherwise));
}

std::string BlockWriter::extra(const std::string& suffix, yaml::Node block) {
  const std::string name = unit().take_name(flat_.name + "_" + suffix);
  flat_.made.emplace_back(name, std::move(block));
  return name;
}

SampleTime BlockWriter::sample_time(const std::string& parameter, const std::string& otherwise) {
  const Value found = value(parameter, otherwise);
  if (found.cells.empty() || found.cells.size() > 2)
    throw Untranslated(fmt::format("its sample time {} is no period", text(parameter, otherwise)));
  SampleTime time;
  time.period = found.cells[0];
  if (found.cells.size() == 2) time.offset = found.cells[1];
  const double period = time.period.number;
  using Kind = SampleTime::Kind;
  time.kind = std::isinf(period) ? Kind::constant
              : period < 0.0     ? Kind::inherited
              : period == 0.0    ? Kind::continuous
                                 : Kind::discrete;
  if (time.kind != Kind::discrete) return time;
  for (const double one : {period, time.offset.number})
    if (one > 0.0) collected_.periods.push_back(one);
  return time;
}

yaml::Node BlockWriter::every_node(const SampleTime& time) const {
  if (time.kind != SampleTime::Kind::discrete) return {};
  const bool has_offset = !time.offset.text.empty() || time.offset.number != 0.0;
  if (!has_offset) return cell_node(time.period);
  return map_of({{"period", cell_node(time.period)}, {"offset", cell_node(time.offset)}});
}

BlockWriter& BlockWriter::every(const std::string& parameter, const std::string& otherwise) {
  const SampleTime time = sample_time(parameter, otherwise);
  return time.kind == SampleTime::Kind::discrete ? key("every", every_node(time)) : *this;
}

void BlockWriter::ignore(const std::string& name, const std::string& without_effect) const {
  const std::string written = text(name, without_effect);
  if (written != without_effect && !written.empty())
    note(fmt::format("its {} is {}, which is not translated", name, on_one_line(written)));
}

/// True for data types whose numbers are those of double precision.
static bool is_plain_type(const std::string& type) {
  return type.empty() || type.starts_with("Inherit") || type == "double" || type == "boolean" ||
         type == "Boolean" || type == "Same as first input" || type == "Logical" || type == "auto" ||
         type.starts_with("Bus:");
}

void BlockWriter::check_types() const {
  for (const char* name : {"OutDataTypeStr", "OutDataTypeMode", "OutDataType"}) {
    const std::string type = text(name, "double");
    const bool is_default = (type.starts_with("fixdt(1,16") && std::string(name) == "OutDataType") ||
                            type.find("sfix(16)") != type.npos;
    if (!is_plain_type(type) && !is_default)
      deviates(
          fmt::format("its data type is {}, and its signal is of double precision here", on_one_line(type)));
  }
  for (const auto& [name, type] : block_.texts)
    if (name.ends_with("DataTypeStr") && name != "OutDataTypeStr" && !is_plain_type(type))
      deviates(fmt::format("its {} is {}, and that is of double precision here", name, on_one_line(type)));
}

void BlockWriter::check_sample_time() const {
  const std::string text = this->text("SampleTime", "-1");
  const auto has_every = [](const auto& made) { return made.second.find("every") != nullptr; };
  if (text == "-1" || text == "0" || text == "inf" || flat_.made.empty()) return;
  if (std::ranges::any_of(flat_.made, has_every)) return;
  const Value time = value("SampleTime", "-1");
  if (time.is_scalar() && (time.cells[0].number <= 0.0 || std::isinf(time.cells[0].number))) return;
  deviates(fmt::format("its sample time {} is not translated; give it `every`", on_one_line(text)));
}

void BlockWriter::check_common(bool locates_events) const {
  check_types();
  check_sample_time();
  ignore("AbsoluteTolerance", "auto");
  const std::string method = text("ApproximationMethod", "None");
  if (method != "None" && !method.empty())
    deviates(fmt::format("its approximation is {} in Simulink, and its function is exact here",
                         on_one_line(method)));
  if (text("SamplingMode", "Sample based") == "Frame based")
    deviates("works on frames in Simulink, and on samples here");
  if (locates_events && text("ZeroCross", "on") == "off")
    note("its zero crossings are not located in Simulink, and are here");
}

void BlockWriter::start_again() {
  flat_.made.clear();
  flat_.outputs.clear();
}

}  // namespace stepwire::simulink
