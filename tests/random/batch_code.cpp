#include "tests/random/batch_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <regex>
#include <set>

#include "engine/base/io/file.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/diagram_struct.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/codegen/headers.hpp"
#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/library.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::random {

namespace {

constexpr std::size_t most_pieces = 40;

/// A format of fmt that gives this text, with a number for each NUMBER.
std::string numbered(const std::string& text) {
  std::string made;
  for (const char c : text) made += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
  return std::regex_replace(made, std::regex("NUMBER"), "{0}");
}

std::string in_namespace(const std::string& text) {
  return "namespace made_NUMBER {\nnamespace {\nusing namespace stepwire;\n" + text + "\n}\n}\n";
}

std::string steps_text(const codegen::GeneratedProgram& program) {
  std::string text = in_namespace(program.text);
  for (const char* function : {"evaluate", "advance"})
    text += fmt::format(
        "extern \"C\" [[gnu::visibility(\"default\")]] void {0}_NUMBER(double* "
        "w, const double* numbers, "
        "std::int64_t tick) {{ made_NUMBER::{0}(w, numbers, tick); }}\n",
        function);
  return text;
}

std::string lanes_text(const codegen::GeneratedProgram& program) {
  return in_namespace(program.text) +
         "extern \"C\" [[gnu::visibility(\"default\")]] void "
         "run_NUMBER(plan::LaneTask& task) { "
         "made_NUMBER::run(task); }\n";
}

std::string program_text(const plan::Plan& plan, const codegen::Tuning& tuning,
                         const codegen::GeneratedProgram& program) {
  const codegen::Groups groups(plan, tuning);
  const std::string space = "own_NUMBER";
  std::string definitions = codegen::struct_definitions(plan, tuning, groups, space);
  // One source has several programs.
  definitions = std::regex_replace(definitions, std::regex(R"( ::(reset|evaluate|advance|updates_at_end)\()"),
                                   " made_NUMBER::$1(");
  definitions.insert(definitions.find("{\n") + 2, "using namespace made_NUMBER;\n");
  const std::string head = "extern \"C\" [[gnu::visibility(\"default\")]] ";
  return codegen::struct_text(plan, tuning, groups, space) + in_namespace(program.text) + definitions + head +
         "void* make_NUMBER() { return new own_NUMBER::Diagram; }\n" + head +
         "void free_NUMBER(void* d) { delete "
         "static_cast<own_NUMBER::Diagram*>(d); }\n" +
         head +
         "void tick_NUMBER(void* d, double* numbers) {\n"
         "  auto& own = *static_cast<own_NUMBER::Diagram*>(d);\n  "
         "own.evaluate();\n"
         "  own_NUMBER::Diagram::State state;\n  own.save(state);\n"
         "  std::memcpy(numbers, state.numbers, sizeof state.numbers);\n}\n" +
         head +
         "void next_NUMBER(void* d) { "
         "static_cast<own_NUMBER::Diagram*>(d)->advance(); }\n";
}

/// Flags beside those of every compilation. Less is optimised, as compiling is what takes the time here.
std::vector<std::string> flags_of(int lanes, const std::vector<std::string>& headers) {
  std::vector<std::string> flags = codegen::library_flags();
  flags.push_back(lanes == 1 ? "-O0" : "-O1");  // without -O1 a loop over lanes stays one
  if (lanes == 1) return flags;
  const auto native = codegen::flags_for_this_machine(headers);
  flags.insert(flags.end(), native.begin(), native.end());
  flags.push_back("-fopenmp-simd");
  return flags;
}

template <class Function>
Function as(void* address) {
  return reinterpret_cast<Function>(address);
}

}  // namespace

BatchCode::Piece& BatchCode::piece(Piece wanted) {
  const std::string text = wanted.text;
  Piece& piece = pieces_.try_emplace(text, std::move(wanted)).first->second;
  problem_ = piece.problem;
  return piece;
}

std::optional<plan::CompiledPlan> BatchCode::compile(const plan::Plan& plan,
                                                     const std::vector<plan::VariableBlock>& variable,
                                                     const plan::CodeLimits&) {
  const codegen::GeneratedProgram program = codegen::make_steps(plan, variable);
  Piece& made = piece({numbered(steps_text(program)), program.headers});
  if (made.functions.empty()) return std::nullopt;
  using Step = void (*)(double*, const double*, std::int64_t);
  return plan::CompiledPlan{{as<Step>(made.functions["evaluate"]), as<Step>(made.functions["advance"])},
                            variable};
}

std::optional<plan::CompiledLanes> BatchCode::compile_lanes(const plan::Plan& plan,
                                                            const plan::RunDifferences& differences,
                                                            const plan::CodeLimits&, std::string& why) {
  const int count = lanes();
  why = count == 1 ? "no lanes here" : codegen::why_not_in_lanes(plan);
  if (!why.empty()) return std::nullopt;
  const codegen::GeneratedProgram program = codegen::make_lanes(plan, differences, count);
  if (codegen::flags_for_this_machine(program.headers).empty()) why = "blocks of it use other libraries";
  if (!why.empty()) return std::nullopt;
  Piece& made = piece({numbered(lanes_text(program)), program.headers, count});
  why = made.problem.empty() ? "it is not compiled yet" : "the compiler refuses it: " + made.problem;
  if (made.functions.empty()) return std::nullopt;
  return plan::CompiledLanes{as<void (*)(plan::LaneTask&)>(made.functions["run"]), count,
                             differences.variable, codegen::lane_places(plan, differences, count).places};
}

int BatchCode::lanes() {
  static const int count = codegen::GeneratedCode(run::code_trial()).lanes();
  return count;
}

std::optional<OwnProgram> BatchCode::program(const plan::Plan& plan, bool constant_parameters) {
  const codegen::Tuning tuning = constant_parameters ? codegen::Tuning{} : codegen::tuning_of(plan);
  const codegen::GeneratedProgram program = codegen::make_program(plan, tuning);
  Piece& made = piece({numbered(program_text(plan, tuning, program)), program.headers});
  if (made.functions.empty()) return std::nullopt;
  return OwnProgram{as<void* (*)()>(made.functions["make"]), as<void (*)(void*)>(made.functions["free"]),
                    as<void (*)(void*, double*)>(made.functions["tick"]),
                    as<void (*)(void*)>(made.functions["next"])};
}

std::optional<plan::CompiledPlan> BatchCode::as_runs_have_it(const plan::Plan& plan) {
  const codegen::GeneratedProgram program = codegen::make_steps(plan, {});
  Piece& made = piece({"// alone\n" + program.text, program.headers, 1, program});
  if (made.functions.empty()) return std::nullopt;
  using Step = void (*)(double*, const double*, std::int64_t);
  return plan::CompiledPlan{{as<Step>(made.functions["evaluate"]), as<Step>(made.functions["advance"])}, {}};
}

void BatchCode::compile_all() {
  const std::vector<Group> groups = open_groups();
  parallel::in_parallel(groups.size(), 0, [&](std::size_t i) { compile(groups[i]); });
  units_.make_all(compiler_);
}

/// Those with lanes apart, as they see other headers.
std::vector<BatchCode::Group> BatchCode::open_groups() {
  std::map<int, Group> open;
  for (auto& [text, piece] : pieces_)
    if (!piece.done && !piece.whole) open[piece.lanes].push_back(&piece);
  std::vector<Group> groups;
  for (auto& [text, piece] : pieces_)
    if (!piece.done && piece.whole) groups.push_back({&piece});
  for (const auto& [lanes, pieces] : open) {
    const std::size_t count = (pieces.size() + most_pieces - 1) / most_pieces;
    const std::size_t first = groups.size();
    groups.resize(first + count);
    for (std::size_t i = 0; i < pieces.size(); ++i) groups[first + i % count].push_back(pieces[i]);
  }
  return groups;
}

std::string BatchCode::source_of(const Group& group) {
  std::set<std::string> headers;
  for (const Piece* piece : group) headers.insert(piece->headers.begin(), piece->headers.end());
  std::string source = "#include <bit>\n#include <cstring>\n";
  source += codegen::library_head({headers.begin(), headers.end()}, group.front()->lanes);
  source += "using namespace stepwire;\n";
  for (std::size_t i = 0; i < group.size(); ++i) source += fmt::format(fmt::runtime(group[i]->text), i);
  return source;
}

void BatchCode::compile_whole(Piece& piece) {
  const codegen::ProgramFunctions made = codegen::CodeCache().load(
      *piece.whole, compiler_, {}, [](const codegen::ProgramFunctions&) { return ""; }, piece.problem);
  piece.done = true;
  if (!made) return;
  piece.functions["evaluate"] = reinterpret_cast<void*>(made.steps.evaluate);
  piece.functions["advance"] = reinterpret_cast<void*>(made.steps.advance);
}

/// Where one of many does not compile, each half is tried.
void BatchCode::compile(const Group& group) {
  if (group.front()->whole) return compile_whole(*group.front());
  const subprocess::ScratchFolder folder;
  const std::string stem = folder.path() + "/batch";
  std::set<std::string> headers;
  for (const Piece* piece : group) headers.insert(piece->headers.begin(), piece->headers.end());
  const std::vector<std::string> all(headers.begin(), headers.end());
  io::write_file(stem + ".cpp", source_of(group));
  std::string problem =
      compiler_.compile(stem + ".cpp", stem + ".so", flags_of(group.front()->lanes, all), {});
  if (!problem.empty() && group.size() > 1) {
    const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
    compile(Group(group.begin(), middle));
    return compile(Group(middle, group.end()));
  }
  void* library = problem.empty() ? codegen::load_library(io::read_file(stem + ".so"), problem) : nullptr;
  for (std::size_t i = 0; i < group.size(); ++i) {
    group[i]->done = true;
    group[i]->problem = problem.substr(0, 2000);
    for (const char* function : {"evaluate", "advance", "run", "make", "free", "tick", "next"})
      if (void* address = library ? ::dlsym(library, fmt::format("{}_{}", function, i).c_str()) : nullptr)
        group[i]->functions[function] = address;
  }
}

}  // namespace stepwire::random
