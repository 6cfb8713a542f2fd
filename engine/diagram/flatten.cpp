#include "engine/diagram/flatten.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace stepwire {

namespace {

using Out = std::back_insert_iterator<std::string>;

struct ValueText {
  Out out;

  void operator()(double number) { fmt::format_to(out, "{}", number); }
  void operator()(bool flag) { fmt::format_to(out, "{}", flag); }
  void operator()(const std::string& text) { fmt::format_to(out, "\"{}\"", text); }
  void operator()(const Eigen::VectorXd& vector) {
    fmt::format_to(out, "[{}]", fmt::join(vector.begin(), vector.end(), ", "));
  }
  void operator()(const Eigen::MatrixXd& matrix) {
    const auto elements = matrix.reshaped();
    fmt::format_to(out, "{}x{}[{}]", matrix.rows(), matrix.cols(),
                   fmt::join(elements.begin(), elements.end(), ", "));
  }
  void operator()(const Value::List& list) {
    fmt::format_to(out, "[");
    for (const Value& item : list) std::visit(*this, item.content);
    fmt::format_to(out, "]");
  }
  void operator()(const Value::Map& map) {
    for (const ValueEntry& entry : map) {
      fmt::format_to(out, "{{{}: ", entry.key);
      std::visit(*this, entry.value.content);
      fmt::format_to(out, "}}");
    }
  }
};

void write_source(Out out, const Diagram& diagram, const Source& source) {
  if (source.block < 0) return ValueText{out}(source.constant);
  const DiagramBlock& block = diagram.blocks[static_cast<std::size_t>(source.block)];
  fmt::format_to(out, "{}.{}", block.name,
                 block.type().outputs[static_cast<std::size_t>(source.output)].name);
}

void write_block(Out out, const Diagram& diagram, const DiagramBlock& block) {
  const BlockType& type = block.type();
  fmt::format_to(out, "{}: {}", block.name, type.name);
  if (block.every) fmt::format_to(out, " every={}", *block.every);
  for (const ParameterSpec& parameter : type.parameters) {
    fmt::format_to(out, " {}=", parameter.name);
    std::visit(ValueText{out}, parameter.get(block.block.get()).content);
  }
  for (const InitialValue& initial : block.initial) {
    fmt::format_to(out, " initial_{}=", type.states[static_cast<std::size_t>(initial.state)].name);
    ValueText{out}(initial.value);
  }
  for (std::size_t i = 0; i < block.inputs.size(); ++i)
    for (const Source& source : block.inputs[i]) {
      fmt::format_to(out, " {}<-", type.inputs[i].name);
      write_source(out, diagram, source);
    }
  fmt::format_to(out, "\n");
}

}  // namespace

std::string flattened_text(const Diagram& diagram) {
  std::string text;
  Out out(text);
  fmt::format_to(out, "step={} stop={} solver={}\n", diagram.step, diagram.stop, diagram.solver);
  for (const DiagramBlock& block : diagram.blocks) write_block(out, diagram, block);
  for (const RecordRequest& request : diagram.records) {
    fmt::format_to(out, "record every={}", request.every.value_or(diagram.step));
    for (const RecordedSignal& signal : request.signals) fmt::format_to(out, " {}", signal.name);
    fmt::format_to(out, "\n");
  }
  if (diagram.stop_when) fmt::format_to(out, "stop_when {}\n", diagram.stop_when->expression.text());
  return text;
}

std::string diagram_hash(const Diagram& diagram) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (unsigned char c : flattened_text(diagram)) hash = (hash ^ c) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

}  // namespace stepwire
