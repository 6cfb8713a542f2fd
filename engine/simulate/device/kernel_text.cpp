#include "engine/simulate/device/kernel_text.hpp"

#include <fmt/format.h>

#include "engine/base/math/elementary.hpp"
#include "engine/model/plan/active_pieces.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/solve/event_task.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::device {

namespace {

constexpr std::size_t most_numbers = 60'000;  // a thread may have half a megabyte of its own

/// Placeholders: checked numbers, begin of the rows, condition of the last tick, rows, condition after a
/// step.
constexpr char form[] =
    "/// True if a number is not finite.\n"
    "inline bool unfinite(const double* w) {{\n  double sum = 0.0;\n{0}  return !(sum == 0.0);\n}}\n\n"
    "/// Steps one run through a piece of its ticks.\n"
    "inline void step_run(const device::Piece& piece, std::int64_t run) {{\n"
    "  if (piece.ends[run] != 0) return;\n"
    "  const std::int64_t count = piece.count;\n"
    "  const double* const numbers = piece.numbers + run * piece.table;\n"
    "  double w[size];\n"
    "  for (std::int64_t n = 0; n < size; ++n) w[n] = piece.values[n * count + run];\n"
    "{1}"
    "  std::int32_t end = 0;\n  std::int64_t tick = piece.tick;\n"
    "  for (; tick < piece.end; ++tick) {{\n"
    "    evaluate(w, numbers, tick);\n"
    "    if (unfinite(w)) {{ end = 1 + plan::LaneTask::evaluated; break; }}\n"
    "    if (tick == piece.stop{2}) {{ end = 1 + plan::LaneTask::last; break; }}\n"
    "{3}"
    "    advance(w, numbers, tick);\n"
    "{4}"
    "  }}\n"
    "  for (std::int64_t n = 0; n < size; ++n) piece.values[n * count + run] = w[n];\n"
    "  piece.ends[run] = end;\n  piece.ticks[run] = tick;\n}}\n\n";

/// Placeholder: name of the kernel.
constexpr char entry[] =
    "\n#ifdef __NVPTX__\n"
    "extern \"C\" __attribute__((nvptx_kernel)) void {0}(device::Piece piece) {{\n"
    "  const std::int64_t run = static_cast<std::int64_t>(__nvvm_read_ptx_sreg_ctaid_x()) *\n"
    "                           __nvvm_read_ptx_sreg_ntid_x() + __nvvm_read_ptx_sreg_tid_x();\n"
    "  if (run < piece.count) step_run(piece, run);\n}}\n"
    "#else\n"
    "extern \"C\" [[gnu::visibility(\"default\")]] void {0}(device::Piece piece) {{\n"
    "  for (std::int64_t run = 0; run < piece.count; ++run) step_run(piece, run);\n}}\n"
    "#endif\n";

/// Elementary function, and the line of a kernel that defines it.
struct Defined {
  const char *name, *line;
};

#define STEPWIRE_LINE_OF_ONE(name, error) {#name, "STEPWIRE_KERNEL_OF_ONE(" #name ", \"" error "\")\n"},
#define STEPWIRE_LINE_OF_TWO(name, error) {#name, "STEPWIRE_KERNEL_OF_TWO(" #name ", \"" error "\")\n"},
constexpr Defined functions[] = {STEPWIRE_FUNCTIONS(STEPWIRE_LINE_OF_ONE, STEPWIRE_LINE_OF_TWO)
                                     STEPWIRE_LINE_OF_TWO(pow, "u10")};
#undef STEPWIRE_LINE_OF_ONE
#undef STEPWIRE_LINE_OF_TWO

constexpr const char* declared_in = "engine/base/math/elementary.hpp";

/// Returns the lines for all functions that a program or one of its headers calls.
std::string functions_text(const codegen::GeneratedProgram& program) {
  std::string all = program.text, lines;
  for (const std::string& header : codegen::with_included(program.headers).all)
    if (header != declared_in) all += codegen::header_text(header);
  for (const Defined& function : functions)
    if (all.find(fmt::format("fn::{}(", function.name)) != std::string::npos) lines += function.line;
  return lines;
}

class StepText {
 public:
  explicit StepText(const plan::Plan& plan) : plan_(plan) {}

  std::string text() const {
    return fmt::format(form, finite_text(), begin_of_rows(), last_condition(), rows_text(), end_text());
  }

 private:
  std::string finite_text() const {
    std::string text;
    const plan::Layout& layout = plan_.layout;
    for (const plan::ActivePiece& piece :
         plan::active_pieces(plan_, layout.signals, layout.derivatives + layout.state_count)) {
      text += piece.active < 0 ? "  " : fmt::format("  if (w[{}] != 0.0)\n    ", piece.active);
      text += fmt::format("for (int i = {}; i < {}; ++i) sum += w[i] * 0.0;\n", piece.first, piece.end);
    }
    return text;
  }

  std::int64_t every(std::size_t request) const {
    return record::ticks_between_rows(plan_, plan_.diagram.records[request]);
  }

  std::vector<record::RecordedColumn> columns(std::size_t request) const {
    return record::recorded_columns(plan_, plan_.diagram.records[request]);
  }

  std::string begin_of_rows() const {
    std::string text, before = "run";
    for (std::size_t r = 0; r < plan_.diagram.records.size(); ++r) {
      text += fmt::format("  double* row_{0} = piece.rows + ({1});\n", r, before);
      before += fmt::format(" + piece.rows_of({}) * {} * count", every(r), columns(r).size());
    }
    return text;
  }

  std::string rows_text() const {
    std::string text;
    for (std::size_t r = 0; r < plan_.diagram.records.size(); ++r) {
      text += every(r) > 1 ? fmt::format("    if (piece.rows && tick % {} == 0) {{\n", every(r))
                           : "    if (piece.rows) {\n";
      const auto recorded = columns(r);
      for (std::size_t c = 0; c < recorded.size(); ++c)
        text += fmt::format("      row_{}[{} * count] = w[{}];\n", r, c, recorded[c].offset);
      text += fmt::format("      row_{} += {} * count;\n    }}\n", r, recorded.size());
    }
    return text;
  }

  std::string last_condition() const {
    std::string text;
    if (plan_.splits_steps())
      text += fmt::format(" || w[{}] != 0.0", plan_.layout.events + solve::EventReport::stopped);
    if (const auto& stop = plan_.diagram.stop_when)
      text += fmt::format(" || ({})", stop->expression.cpp_condition([&](std::size_t i) {
        return fmt::format("w[{}]", plan_.offset(stop->variables[i]));
      }));
    return text;
  }

  /// Returns the statement that ends a run after a step with a fault.
  std::string end_text() const {
    std::string condition;
    const auto add = [&](const std::string& more) { condition += (condition.empty() ? "" : " || ") + more; };
    for (std::size_t b = 0; b < plan_.blocks.size(); ++b) {
      const auto& specs = plan_.diagram.blocks[b].type().diagnostics;
      for (std::size_t n = 0; n < specs.size(); ++n)
        if (specs[n].ends_run)
          add(fmt::format("w[{}] != Diagnostic::never", plan_.blocks[b].diagnostics[n].offset));
    }
    if (solve::find_called(plan_.diagram.solver, plan_.diagram.error_control.has_value()))
      add(fmt::format("w[{}] != 0.0", plan_.layout.report));
    if (plan_.splits_steps()) add(fmt::format("w[{}] != 0.0", plan_.layout.events + solve::EventReport::end));
    if (condition.empty()) return "";
    return fmt::format("    if ({}) {{ end = 1 + plan::LaneTask::advanced; break; }}\n", condition);
  }

  const plan::Plan& plan_;
};

}  // namespace

std::string why_not_on_device(const plan::Plan& plan) {
  if (plan.diagram.uses_libm) return "its functions are those of the C library, which a device does not have";
  if (plan.records_instants()) return "it records both sides of instants";
  if (!plan.loops.empty()) return "it has algebraic loops";
  if (plan.layout.size > most_numbers) return "its runs have more numbers than a thread of a device";
  if (codegen::flags_for_this_machine(codegen::headers_of(plan)).empty())
    return "code of it uses Eigen or another library, whose sums have another order on a device";
  return "";
}

KernelText make_kernel(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable) {
  const codegen::GeneratedProgram program = codegen::make_steps(plan, variable);
  KernelText kernel{codegen::library_head(program.headers, 1), program.headers};
  for (const char* header : {"engine/simulate/device/c_library.hpp", "engine/simulate/device/functions.hpp",
                             "engine/simulate/device/piece.hpp", "engine/model/plan/lane_task.hpp"}) {
    kernel.headers.emplace_back(header);
    kernel.source += fmt::format("#include \"{}\"\n", header);
  }
  kernel.source += "\n" + functions_text(program) + "\nnamespace {\n\nusing namespace stepwire;\n\n" +
                   program.text + "\n" + StepText(plan).text() + "}  // namespace\n" +
                   fmt::format(entry, kernel_name);
  return kernel;
}

}  // namespace stepwire::device
