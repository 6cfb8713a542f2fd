#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/block/configure.hpp"
#include "engine/model/block/kernels.hpp"
#include "engine/model/block/spec.hpp"
#include "engine/model/block/symbol.hpp"

namespace stepwire {

struct Outline;

/// When a block runs unless its file says `every`.
enum class Timing {
  inherited,   ///< at the rate of its inputs; once at the start if it has none
  continuous,  ///< follows time itself (sources) or has continuous states
  discrete     ///< acts at ticks; without `every` at its inputs' period, or at every step where those are
               ///< continuous
};

/// Everything known of a kind of block, from its declaration alone.
struct BlockType {
  std::string name;
  std::string doc;
  std::string source;  ///< equation, paper or datasheet, if any
  std::string folder;  ///< the family, e.g. "continuous"
  Symbol symbol;
  Timing timing = Timing::inherited;
  bool file_output = false;
  std::string struct_name;  ///< in C++, with its namespace
  std::string header;  ///< that declares the struct, from the root of the sources, or its full path where it
                       ///< is none of ours; empty if there is none
  std::string declared_at;    ///< "blocks/math/gain.cpp:12"
  std::string not_real_time;  ///< why its steps are not fit for a real-time loop; empty: they are
  std::string not_linear;     ///< why linear analyses refuse it; empty: they do not
  std::string not_generated;  ///< why no code can be made of it, where that is no lack of a header

  std::vector<ParameterSpec> parameters;
  std::vector<InputSpec> inputs;
  std::vector<OutputSpec> outputs;
  std::vector<StateSpec> states;
  std::vector<DiagnosticSpec> diagnostics;
  std::vector<CrossingSpec> crossings;
  bool steady = false;     ///< are its outputs constant between crossings?
  bool at_events = false;  ///< acts at located events though it crosses nothing
  bool smooth = false;     ///< outputs jump only where inputs do
  bool torn = false;       ///< are algebraic loops through it solved for its outputs?
  std::vector<PresetSpec> presets;
  std::vector<MemberSpec> members;  ///< that a run reads and never changes
  std::vector<ClockSpec> clocks;
  std::vector<SizeSpec> sizes;

  Kernels run_outputs, run_derivatives, run_update;
  /// Replaces run_outputs at ticks and events, before update(); empty for a block with one outputs().
  Kernels run_outputs_at_instant;
  /// Replaces run_update at located events; empty for a block with one update().
  Kernels run_update_at_event;
  /// Writes the numbers of all crossings; null where there are none.
  void (*run_crossings)(const void* block, double* numbers) = nullptr;
  /// Time of the next jump or bend of an output after the present time, by the time alone [s]; infinite
  /// without one. Null for a block that declares no edges.
  double (*run_next_edge)(const void* block) = nullptr;
  void (*configure)(void* block, Configure& is) = nullptr;
  void (*prepare)(void* block) = nullptr;
  void (*start)(void* block) = nullptr;
  /// Adds the lines that a configured block offers to figures; null where it has none.
  void (*outline)(const void* block, Outline& lines) = nullptr;

  std::size_t bytes = 0, alignment = 0;
  std::function<void(void* memory)> construct;
  void (*copy)(void* memory, const void* block) = nullptr;
  void (*destroy)(void* block) = nullptr;

  const ParameterSpec* parameter(std::string_view key) const;
  int input(std::string_view key) const;   ///< index, or -1
  int output(std::string_view key) const;  ///< index, or -1
  int state(std::string_view key) const;   ///< index, or -1
  bool has_continuous_state() const;
};

/// Owns one block of a type known only at run time.
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
