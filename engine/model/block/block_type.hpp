#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/block/configure.hpp"
#include "engine/model/block/kernels.hpp"
#include "engine/model/block/spec.hpp"

namespace stepwire {

/// Symbol of a block in a drawing: an outline with a text or a curve. Without either the drawing shows the
/// type's name.
struct Symbol {
  enum class Outline {
    box,
    triangle,  ///< points in the direction of the signal
    circle,    ///< a summing junction
    bar        ///< thick line: signals are joined or split
  };

  /// Text with placeholders. `{name}` is a parameter as written in the file, `{name|else}` the word `else`
  /// where that is too long. `{name:s}` is the polynomial in s with these coefficients, highest power first.
  /// A " / " is a fraction bar; numbers in a fraction are in SI without unit. A line break starts a second
  /// line.
  std::string text{};
  /// Path data as in SVG (M, L, H, V, C, Z) in the square from -1 to 1, but with y upwards.
  std::string curve{};
  bool axes = false;  ///< the curve is output over input: thin axes are drawn behind it
  Outline outline = Outline::box;
  std::string signs{};  ///< parameter that holds a sign for each input
};

struct Outline;

/// Timing of a block without `every` in its file.
enum class Timing {
  inherited,   ///< At the rate of its inputs; once at the start without inputs.
  continuous,  ///< For sources that are functions of time, and blocks with continuous states.
  discrete     ///< At ticks; without `every` at the period of its inputs, or at every step where those are
               ///< continuous.
};

/// Description of a kind of block, derived from its declaration alone.
struct BlockType {
  std::string name;
  std::string doc;
  std::string source;  ///< equation, paper or datasheet; may be empty
  std::string folder;  ///< the family, such as "continuous"
  Symbol symbol;
  Timing timing = Timing::inherited;
  bool file_output = false;
  std::string struct_name;  ///< C++ name with its namespace.
  std::string header;  ///< Header that declares the struct: relative to the root of the sources, or a full
                       ///< path outside of the library. Empty without one.
  std::string declared_at;    ///< Location of the declaration, "blocks/math/gain.cpp:12".
  std::string not_real_time;  ///< Reason why a real-time loop refuses it; empty without one.
  std::string delayed_by;     ///< Input that has the time of an exact delay; empty for other blocks.
  std::string discrete;       ///< Block with a period in the place of this continuous one; may be empty.
  std::string not_generated;  ///< Reason, except a missing header, against code generation; may be empty.

  std::vector<ParameterSpec> parameters;
  std::vector<InputSpec> inputs;
  std::vector<OutputSpec> outputs;
  std::vector<StateSpec> states;
  std::vector<DiagnosticSpec> diagnostics;
  std::vector<CrossingSpec> crossings;
  bool steady = false;     ///< its outputs are constant between crossings
  bool at_events = false;  ///< acts at located events although it has no crossings
  bool at_end = false;     ///< its update() is called at the last row, too
  bool smooth = false;     ///< outputs jump only where inputs do
  bool torn = false;       ///< algebraic loops through it are solved for its outputs
  std::vector<PresetSpec> presets;
  std::vector<MemberSpec> members;  ///< members that a run reads and never changes
  std::vector<ClockSpec> clocks;
  std::vector<SizeSpec> sizes;

  Kernels run_outputs, run_derivatives, run_update;
  /// Replaces run_outputs at ticks and events, before update(); empty for a block with one outputs().
  Kernels run_outputs_at_instant;
  /// Replaces run_update at located events; empty for a block with one update().
  Kernels run_update_at_event;
  Kernels run_update_before_instant;  ///< with the values just before a tick or an event
  /// Writes the values of all crossing functions; nullptr for a block without crossings.
  void (*run_crossings)(const void* block, double* numbers) = nullptr;
  /// Returns the time [s] of the next jump or bend of an output that is caused by time alone; infinity
  /// without one. nullptr for a block that declares no edges.
  double (*run_next_edge)(const void* block) = nullptr;
  void (*configure)(void* block, Configure& is) = nullptr;
  void (*prepare)(void* block) = nullptr;
  void (*start)(void* block) = nullptr;
  /// Adds the lines that a configured block offers to figures; nullptr for a block without any.
  void (*outline)(const void* block, Outline& lines) = nullptr;

  std::size_t bytes = 0, alignment = 0;
  std::function<void(void* memory)> construct;
  void (*copy)(void* memory, const void* block) = nullptr;
  void (*destroy)(void* block) = nullptr;

  const ParameterSpec* parameter(std::string_view key) const;
  int input(std::string_view key) const;   ///< index; -1 if it is missing
  int output(std::string_view key) const;  ///< index; -1 if it is missing
  int state(std::string_view key) const;   ///< index; -1 if it is missing
  bool has_continuous_state() const;
};

/// Owner of one block whose type is known only at run time.
class AnyBlock {
 public:
  explicit AnyBlock(const BlockType& type);
  AnyBlock(const AnyBlock& other);
  AnyBlock(AnyBlock&& other) noexcept;
  AnyBlock& operator=(AnyBlock other) noexcept;
  ~AnyBlock();

  const BlockType& type() const { return *type_; }
  void* get() { return memory_; }
  const void* get() const { return memory_; }

 private:
  const BlockType* type_;
  void* memory_;
};

}  // namespace stepwire
