// A generated program follows its parameters as the interpreter follows set(), whatever block they reach.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "engine/model/diagram/load.hpp"
#include "engine/simulate/codegen/diagram_struct.hpp"
#include "engine/simulate/codegen/program.hpp"
#include "engine/simulate/codegen/value_text.hpp"
#include "tests/blocks/contract_library.hpp"
#include "tests/blocks/contract_values.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 20, change_at = 5;

struct Made {
  std::string yaml;
  plan::Plan plan;
  codegen::Tuning tuning;
};

/// Each block as it is used least, and with all of its inputs.
std::vector<Made> all_made() {
  std::vector<Made> all;
  diagram::Loader loader(library());
  const auto beside = fs::path(STEPWIRE_SOURCE_DIR) / "tests" / "blocks" / "contract.yaml";
  for (const BlockType* type : library().types()) {
    if (type->header.empty() || type->file_output) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      if (wiring.may_be_refused) continue;
      const std::string yaml = with_parameters(wiring);
      if (yaml.empty()) continue;
      INFO(yaml);
      plan::Plan plan = plan::make_plan(loader.load_text(yaml, beside.string()));
      codegen::Tuning tuning = codegen::tuning_of(plan);
      if (!tuning.parameters.empty()) all.push_back({yaml, std::move(plan), std::move(tuning)});
    }
  }
  return all;
}

std::string source_of(const std::vector<Made>& all) {
  std::set<std::string> headers;
  std::string body;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [yaml, plan, tuning] = all[i];
    const codegen::GeneratedProgram program = codegen::make_program(plan, tuning);
    headers.insert(program.headers.begin(), program.headers.end());
    const codegen::Groups groups(plan, tuning);
    const std::string space = fmt::format("tuned_{}", i), made = fmt::format("made_{}", i);
    std::string text = codegen::struct_definitions(plan, tuning, groups, space);
    // One source contains several programs, so these calls name the namespace of their program.
    text = std::regex_replace(text, std::regex(R"( ::(reset|evaluate|advance|updates_at_end)\()"), " " + made + "::$1(");
    text.insert(text.find("{\n") + 2, "using namespace " + made + ";\n");
    body += codegen::struct_text(plan, tuning, groups, space) +
            fmt::format("namespace {} {{\nnamespace {{\nusing namespace stepwire;\n{}}}\n}}\n", made,
                        program.text) +
            text +
            fmt::format(
                "extern \"C\" EXPORTED void* make_{0}() {{ return new {1}::Diagram; }}\n"
                "extern \"C\" EXPORTED void free_{0}(void* d) {{ delete static_cast<{1}::Diagram*>(d); }}\n"
                "extern \"C\" EXPORTED void evaluate_{0}(void* d, double* numbers) {{\n"
                "  auto& own = *static_cast<{1}::Diagram*>(d);\n  own.evaluate();\n"
                "  {1}::Diagram::State state;\n  own.save(state);\n"
                "  std::memcpy(numbers, state.numbers, sizeof state.numbers);\n}}\n"
                "extern \"C\" EXPORTED void advance_{0}(void* d) {{ "
                "static_cast<{1}::Diagram*>(d)->advance(); }}\n"
                "extern \"C\" EXPORTED double* parameters_{0}(void* d) {{\n"
                "  return reinterpret_cast<double*>(&static_cast<{1}::Diagram*>(d)->parameters);\n}}\n"
                "extern \"C\" EXPORTED const char* fault_{0}(void* d) {{\n"
                "  return static_cast<{1}::Diagram*>(d)->parameter_fault();\n}}\n",
                i, space);
  }
  std::string source =
      "#define EXPORTED [[gnu::visibility(\"default\")]]\n#include <bit>\n#include <cmath>\n#include "
      "<cstdint>\n#include <cstring>\n#include <limits>\n";
  for (const std::string& header : headers) source += fmt::format("#include \"{}\"\n", header);
  return source + "using namespace stepwire;\n" + body;
}

/// A generated program that runs.
class Instance {
 public:
  Instance(const ContractLibrary& library, std::size_t index) {
    const auto find = [&](const char* name, auto& function) {
      library.find(fmt::format("{}_{}", name, index), function);
    };
    void* (*make)() = nullptr;
    find("make", make);
    find("free", free_);
    find("evaluate", evaluate_);
    find("advance", advance_);
    find("parameters", parameters_);
    find("fault", fault_);
    diagram_ = make();
  }
  ~Instance() { free_(diagram_); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  void evaluate(double* numbers) { evaluate_(diagram_, numbers); }
  void advance() { advance_(diagram_); }
  double* parameters() { return parameters_(diagram_); }
  const char* fault() { return fault_(diagram_); }

 private:
  void* diagram_ = nullptr;
  void (*free_)(void*) = nullptr;
  void (*evaluate_)(void*, double*) = nullptr;
  void (*advance_)(void*) = nullptr;
  double* (*parameters_)(void*) = nullptr;
  const char* (*fault_)(void*) = nullptr;
};

void write(const Value& value, double* place) {
  if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content)) {
    for (Eigen::Index r = 0; r < matrix->rows(); ++r)
      for (Eigen::Index c = 0; c < matrix->cols(); ++c) *place++ = (*matrix)(r, c);
    return;
  }
  for (const double number : codegen::numbers_of(value)) *place++ = number;
}

enum class Outcome { same, differs, refused, structure };

/// Changes one parameter before a tick and compares the generated program with the interpreter.
Outcome outcome(const plan::Plan& plan, const ContractLibrary& library, std::size_t index, std::size_t place,
                int parameter, const Value& value) {
  run::Executor interpreted(plan);
  Instance generated(library, index);
  std::vector<double> numbers(plan.layout.size);
  for (std::int64_t tick = 0; tick < ticks && interpreted.healthy(); ++tick) {
    if (tick == change_at) {
      try {
        const auto& name = plan.diagram.parameters[static_cast<std::size_t>(parameter)].name;
        if (interpreted.set(name, yaml_of(value)) != run::Executor::Setting::done) return Outcome::structure;
      } catch (const yaml::Error&) {
        return Outcome::refused;
      }
      write(value, generated.parameters() + place);
    }
    interpreted.evaluate();
    generated.evaluate(numbers.data());
    if (generated.fault() || !same_numbers(plan, interpreted.values(), numbers.data()))
      return Outcome::differs;
    interpreted.advance();
    generated.advance();
  }
  return Outcome::same;
}

}  // namespace

TEST_CASE("a generated program follows each number of each block as the interpreter follows set()",
          "[full]") {
  if (!has_compiler()) return;
  const std::vector<Made> all = all_made();
  const ContractLibrary library(source_of(all), "-O0");
  std::size_t followed = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const codegen::Groups groups(all[i].plan, all[i].tuning);
    std::size_t place = 0;
    for (std::size_t p = 0; p < all[i].tuning.parameters.size(); ++p) {
      const int parameter = all[i].tuning.parameters[p];
      const auto& known = all[i].plan.diagram.parameters[static_cast<std::size_t>(parameter)];
      const ParameterSpec* spec =
          all[i].plan.diagram.blocks[tested_in(all[i].plan)].type().parameter(known.name.substr(2));
      for (const auto& [factor, more] :
           std::vector<std::pair<double, double>>{{1.25, 0.0}, {0.7, 0.1}, {2.0, 3.0}}) {
        const Value value = changed(known.value, factor, more, spec->kind == ParameterKind::integer);
        INFO(all[i].yaml << known.name << ": " << yaml_of(value));
        const Outcome is = outcome(all[i].plan, library, i, place, parameter, value);
        CHECK(is != Outcome::differs);
        CHECK(is != Outcome::structure);
        followed += is == Outcome::same ? 1 : 0;
      }
      place += groups.parameters.members[p].count();
    }
  }
  CHECK(followed > 500);
}
