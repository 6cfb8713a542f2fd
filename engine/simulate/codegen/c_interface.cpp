#include "engine/simulate/codegen/c_interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/simulate/codegen/cpp_words.hpp"
#include "engine/simulate/codegen/tuning_text.hpp"

namespace stepwire::codegen {

namespace {

/// Replaces every @ by the prefix of all names.
std::string with_space(std::string text, const std::string& space) {
  for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += space.size())
    text.replace(at, 1, space);
  return text;
}

const char* const lifecycle =
    "/** Makes the instance, at time 0, with the parameters of the file. Comes before all else. */\n"
    "void @_init(@_instance* instance);\n"
    "/** Puts everything at time 0. */\nvoid @_reset(@_instance* instance);\n"
    "/** Reads the inputs and computes the outputs of this tick. */\n"
    "void @_evaluate(@_instance* instance);\n"
    "/** Goes on by a step. */\nvoid @_advance(@_instance* instance);\n"
    "/** Both. */\nvoid @_step(@_instance* instance);\n"
    "int64_t @_tick(const @_instance* instance);\n"
    "/** Of this tick [s]. */\ndouble @_time(const @_instance* instance);\n"
    "/** Is every signal and state a finite number? */\nbool @_finite(const @_instance* instance);\n"
    "/** Why a block has ended the run; NULL while none has. */\n"
    "const char* @_fault(const @_instance* instance);\n"
    "/** Is the diagram's stop_when true? */\nbool @_stops(const @_instance* instance);\n"
    "void @_save(const @_instance* instance, @_state* state);\n"
    "/** False, and nothing happens, for a state of another diagram. */\n"
    "bool @_restore(@_instance* instance, const @_state* state);\n";

const char* const parameter_checks =
    "/** Why these parameters would be refused; NULL where they would not. */\n"
    "const char* @_check(const @_instance* instance, const @_parameters* parameters);\n"
    "/** Why those that were set were refused at the last evaluate or reset; NULL where they hold. "
    "Until they "
    "are right\n    the former ones hold. */\n"
    "const char* @_parameter_fault(const @_instance* instance);\n";

class CText {
 public:
  CText(const plan::Plan& plan, const Tuning& tuning, const Groups& groups, const std::string& space)
      : plan_(plan), tuning_(tuning), groups_(groups), space_(space) {}

  std::string types() const {
    std::string text;
    for (const Group* group : shown()) text += type(*group);
    return text +
           with_space(
               fmt::format("/** All that moves in a run: plain numbers, to be kept anywhere. */\n"
                           "typedef struct {{\n  uint64_t layout; /**< of the diagram that it belongs to */\n"
                           "  int64_t tick;\n  double numbers[{}];\n}} @_state;\n\n"
                           "/** One running diagram; whoever uses it provides the memory. Its content is its "
                           "own. */\n"
                           "typedef struct {{\n  double memory[{}];\n}} @_instance;\n\n",
                           plan_.layout.size, doubles()),
               space_);
  }

  std::string declarations() const {
    std::string text = lifecycle;
    for (const Group* group : shown()) {
      text += fmt::format("void @_get_{0}(const @_instance* instance, @_{0}* {0});\n", group->name);
      if (is_written(*group))
        text += fmt::format("void @_set_{0}(@_instance* instance, const @_{0}* {0});\n", group->name);
    }
    if (tunes()) text += parameter_checks;
    return with_space(text, space_);
  }

  std::string definitions() const {
    std::string text =
        "void @_init(@_instance* instance) { ::new (static_cast<void*>(instance->memory)) Diagram; }\n"
        "void @_reset(@_instance* instance) { of(instance).reset(); }\n"
        "void @_evaluate(@_instance* instance) { of(instance).evaluate(); }\n"
        "void @_advance(@_instance* instance) { of(instance).advance(); }\n"
        "void @_step(@_instance* instance) { of(instance).step(); }\n"
        "int64_t @_tick(const @_instance* instance) { return of(instance).tick; }\n"
        "double @_time(const @_instance* instance) { return of(instance).time(); }\n"
        "bool @_finite(const @_instance* instance) { return of(instance).finite(); }\n"
        "const char* @_fault(const @_instance* instance) { return of(instance).fault(); }\n"
        "bool @_stops(const @_instance* instance) { return of(instance).stops(); }\n"
        "void @_save(const @_instance* instance, @_state* state) {\n"
        "  Diagram::State own;\n  of(instance).save(own);\n  copy(own, *state);\n}\n"
        "bool @_restore(@_instance* instance, const @_state* state) {\n"
        "  Diagram::State own;\n  copy(*state, own);\n  return of(instance).restore(own);\n}\n";
    for (const Group* group : shown()) text += access(*group);
    if (tunes())
      text +=
          "const char* @_check(const @_instance* instance, const @_parameters* parameters) {\n"
          "  Diagram::Parameters own;\n  copy(*parameters, own);\n  return of(instance).check(own);\n}\n"
          "const char* @_parameter_fault(const @_instance* instance) { return "
          "of(instance).parameter_fault(); }\n";
    return with_space(text, space_);
  }

 private:
  bool tunes() const { return !groups_.parameters.members.empty(); }
  bool is_written(const Group& group) const {
    return group.name == "inputs" || group.name == "parameters" || group.name == "states";
  }

  std::vector<const Group*> shown() const {
    std::vector<const Group*> shown;
    for (const Group* group :
         {&groups_.inputs, &groups_.outputs, &groups_.recorded, &groups_.parameters, &groups_.states})
      if (!group->members.empty()) shown.push_back(group);
    return shown;
  }

  std::string type(const Group& group) const {
    std::string text = fmt::format("/** {} */\ntypedef struct {{\n", group.doc);
    for (const GroupMember& member : group.members)
      text += fmt::format("  {}; /**< {} */\n", member.declaration(), cpp_comment(member.meaning));
    return text + fmt::format("}} {}_{};\n\n", space_, group.name);
  }

  std::string access(const Group& group) const {
    if (group.name == "states")
      return "void @_get_states(const @_instance* instance, @_states* states) { copy(of(instance).states(), "
             "*states); }\n"
             "void @_set_states(@_instance* instance, const @_states* states) {\n"
             "  Diagram::States own;\n  copy(*states, own);\n  of(instance).set_states(own);\n}\n";
    std::string text = fmt::format(
        "void @_get_{0}(const @_instance* instance, @_{0}* {0}) {{ copy(of(instance).{0}, *{0}); }}\n",
        group.name);
    if (is_written(group))
      text += fmt::format(
          "void @_set_{0}(@_instance* instance, const @_{0}* {0}) {{ copy(*{0}, of(instance).{0}); }}\n",
          group.name);
    return text;
  }

  static std::size_t doubles(const Group& group) {
    std::size_t count = 0;
    for (const GroupMember& member : group.members) count += member.count();
    return count;
  }

  /// Returns the size of an instance in doubles; the source checks it at compile time.
  std::size_t doubles() const {
    constexpr std::size_t tick_and_pointer = 2;
    std::size_t count = doubles(groups_.inputs) + doubles(groups_.outputs) + doubles(groups_.recorded) +
                        plan_.layout.size + tick_and_pointer;
    if (tunes())
      count += 2 * doubles(groups_.parameters) + std::max<std::size_t>(tuning_.numbers.size(), 1) +
               dependent_count(plan_, tuning_) / 8 + 1;
    return count;
  }

  const plan::Plan& plan_;
  const Tuning& tuning_;
  const Groups& groups_;
  const std::string& space_;
};

const char* const tools = R"text(namespace {

Diagram& of(@_instance* instance) { return *std::launder(reinterpret_cast<Diagram*>(instance->memory)); }
const Diagram& of(const @_instance* instance) {
  return *std::launder(reinterpret_cast<const Diagram*>(instance->memory));
}

/// Between structs of C and C++ with the same members.
template <class From, class To>
void copy(const From& from, To& to) {
  static_assert(sizeof from == sizeof to && std::is_trivially_copyable_v<From> && std::is_trivially_copyable_v<To>);
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
}

static_assert(sizeof(Diagram) <= sizeof(@_instance) && alignof(Diagram) <= alignof(@_instance));
static_assert(std::is_trivially_destructible_v<Diagram>);

}  // namespace

)text";

std::string in_capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

CInterface c_interface(const plan::Plan& plan, const Tuning& tuning, const Groups& groups,
                       const std::string& space, const std::string& header, const std::string& c_header) {
  const CText text(plan, tuning, groups, space);
  const std::string guard = in_capitals(space) + "_C_H";
  return {fmt::format("#ifndef {0}\n#define {0}\n\n#include <stdbool.h>\n#include <stdint.h>\n\n"
                      "#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
                      guard) +
              text.types() + text.declarations() + "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n",
          fmt::format("#include {}\n\n#include <cstring>\n#include <new>\n#include <type_traits>\n\n"
                      "#include {}\n\nusing {}::Diagram;\n\n",
                      cpp_string(c_header), cpp_string(header), space) +
              with_space(tools, space) + text.definitions()};
}

}  // namespace stepwire::codegen
