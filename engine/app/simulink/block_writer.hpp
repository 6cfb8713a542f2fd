#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/app/simulink/flat_model.hpp"
#include "engine/app/simulink/nodes.hpp"
#include "engine/app/simulink/widths.hpp"

namespace stepwire::simulink {

/// Thrown for a block without counterpart; the text is the reason.
class Untranslated : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Records, conditions and times that the translations of all blocks collect for the head of the diagram.
struct Collected {
  struct Recorded {
    Unit* unit;
    std::string source, name;  ///< name: of the record; empty: that of the source
    std::string scope;         ///< name of the scope that shows it; empty: none
  };
  std::vector<Recorded> recorded;
  std::vector<std::string> stops;  ///< conditions that end the run
  std::vector<double> periods;     ///< [s] sample times and offsets
  double shortest = 1e300;         ///< [s] delay that no step may exceed
  bool has_states = false;         ///< continuous ones
  Widths* widths = nullptr;
  double step = 0.0;  ///< [s] of the configuration, or estimated
};

/// Sample time of a block.
struct SampleTime {
  enum class Kind { inherited, continuous, constant, discrete };
  Kind kind = Kind::inherited;
  Cell period{}, offset{};  ///< [s] of a discrete one
};

/// The translation of one block: parameters and wires of Simulink in, keys of a diagram out.
class BlockWriter {
 public:
  BlockWriter(FlatModel& model, std::size_t index, Collected& collected, std::vector<Note>& notes);

  const Block& block() const { return block_; }
  const std::string& name() const { return flat_.name; }
  Unit& unit() const { return *flat_.in->unit; }
  FlatModel& model() const { return model_; }
  /// Returns the system of the block.
  Instance& instance() const { return *flat_.in; }
  /// Returns the name of the signal at an input; empty if it has none.
  std::string signal_name(int input) const {
    return model_.signal_name(*flat_.in, block_, "in:" + std::to_string(input));
  }
  Collected& collected() const { return collected_; }

  /// Returns a parameter of Simulink as it is written.
  std::string text(const std::string& name, const std::string& otherwise = "") const;
  bool is_on(const std::string& name, const std::string& otherwise = "off") const {
    return text(name, otherwise) == "on";
  }
  /// True for a parameter that is in the block or among the defaults of the file.
  bool is_written(const std::string& name) const { return !text(name).empty(); }
  /// Reports that a parameter is not in the file, so that the default of Simulink is written.
  void say_default(const std::string& name, const std::string& otherwise) const;
  /// Evaluates a parameter whose default differs from release to release. Without it the value is missing.
  Value undecided(const std::string& name) const;
  /// Evaluates a parameter. Throws Untranslated, naming it, where that fails.
  Value value(const std::string& name, const std::string& otherwise) const;
  /// Evaluates a parameter that must be one number.
  Cell number(const std::string& name, const std::string& otherwise) const;
  /// Returns the number of a parameter whose value must be known.
  double known(const std::string& name, const std::string& otherwise) const;

  /// Returns the source of an input, from 1, or of a port such as "enable".
  std::string source(int input = 1) const { return source("in:" + std::to_string(input)); }
  std::string source(const std::string& port) const;
  bool is_connected(int input) const;
  /// Returns how many inputs the block has.
  int inputs() const;
  int outputs() const;
  std::size_t width(int input) const { return collected_.widths->of(source(input)); }
  /// Returns the source of all inputs.
  std::vector<yaml::Node> sources() const;

  /// Begins the block of the diagram.
  BlockWriter& make(const std::string& type);
  /// Begins the use of a part.
  BlockWriter& make_part(const std::string& file);
  /// Makes a bus of these fields.
  void make_fields(yaml::Node fields);
  BlockWriter& key(const std::string& name, yaml::Node node);
  BlockWriter& key(const std::string& name, const std::string& text) { return key(name, word(text)); }
  BlockWriter& key(const std::string& name, const Value& value) { return key(name, value_node(value)); }
  /// Adds a key with the value of a parameter. Throws Untranslated for an infinite one.
  BlockWriter& key(const std::string& name, const std::string& parameter, const std::string& otherwise) {
    return key(name, finite(parameter, otherwise));
  }
  /// Adds a key with a limit, unless it is infinite.
  BlockWriter& limit(const std::string& name, const std::string& parameter, const std::string& otherwise);
  Value finite(const std::string& parameter, const std::string& otherwise) const;
  /// Adds `u` with the first input.
  BlockWriter& u() { return key("u", source()); }
  /// Adds a further block, and returns its name.
  std::string extra(const std::string& suffix, yaml::Node block);
  void output(int port, const std::string& text) { flat_.outputs[port] = text; }

  /// Returns the sample time of a parameter.
  SampleTime sample_time(const std::string& parameter = "SampleTime", const std::string& otherwise = "-1");
  /// Adds `every` where the sample time is a period.
  BlockWriter& every(const std::string& parameter = "SampleTime", const std::string& otherwise = "-1");
  /// Returns the key `every` of a sample time; an empty node without a period.
  yaml::Node every_node(const SampleTime& time) const;

  /// Adds a sentence to the report on a run that differs from that of the model.
  void deviates(const std::string& sentence) const {
    notes_.push_back({NoteKind::deviates, flat_.path, sentence});
  }
  /// Adds a sentence to the report.
  void note(const std::string& sentence) const {
    notes_.push_back({NoteKind::differs, flat_.path, sentence});
  }
  /// Reports a parameter that is not translated, where it differs from the value without effect.
  void ignore(const std::string& name, const std::string& without_effect) const;
  /// Reports parameters that many types have and this translation leaves out: data types other than double,
  /// sample times, zero crossings that are not located, tolerances, frames.
  void check_common(bool locates_events) const;
  void comment(const std::string& line) { flat_.comments.push_back(line); }
  bool has_made() const { return !flat_.made.empty(); }
  /// Removes all that was made so far.
  void start_again();

 private:
  int written_outputs() const;
  void check_types() const;
  void check_sample_time() const;

  FlatModel& model_;
  FlatBlock& flat_;
  const Block& block_;
  Collected& collected_;
  std::vector<Note>& notes_;
  std::size_t main_ = 0;
};

/// A type of Simulink, its counterpart in words, and the function that writes it.
struct Translation {
  const char* type;         ///< BlockType, or the name of a block of the library
  const char* counterpart;  ///< for the page of imports
  void (*write)(BlockWriter&);
};

/// Returns the translation of a block; nullptr if there is none.
const Translation* translation_of(const Model& model, const Block& block);
/// Returns all translations, sorted by type.
const std::vector<Translation>& translations();

// The families of translations, each in a source of its own.
std::vector<Translation> source_translations(), sink_translations(), math_translations(),
    function_translations(), table_translations(), continuous_translations(), controller_translations(),
    discrete_translations(), nonlinear_translations(), logic_translations(), routing_translations(),
    subsystem_translations();

}  // namespace stepwire::simulink
