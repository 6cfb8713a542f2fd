#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/model/block/block.hpp"
#include "engine/model/block/block_type.hpp"
#include "engine/model/block/kernels.hpp"
#include "engine/model/block/literal.hpp"
#include "engine/model/block/member_name.hpp"
#include "engine/model/block/spec.hpp"
#include "engine/model/block/tree.hpp"
#include "engine/model/signal/file_path.hpp"
#include "engine/model/signal/input.hpp"
#include "engine/model/signal/per_element.hpp"
#include "engine/model/signal/signal.hpp"
#include "engine/model/signal/text.hpp"

namespace stepwire {

namespace detail {

template <class T>
struct PortSize;
template <int n>
struct PortSize<Input<n>> : std::integral_constant<int, n> {};
template <>
struct PortSize<Inputs> : std::integral_constant<int, any_size> {};
template <int n>
struct PortSize<Output<n>> : std::integral_constant<int, n> {};
template <int n>
struct PortSize<State<n>> : std::integral_constant<int, n> {};
template <int n>
struct PortSize<DiscreteState<n>> : std::integral_constant<int, n> {};

/// Returns the shape of a port: its fixed size, else the declared shape, else "n".
template <class Port>
std::string shape_of(const std::string& given) {
  if constexpr (PortSize<Port>::value == any_size) {
    return given.empty() ? "n" : given;
  } else {
    return std::to_string(PortSize<Port>::value);
  }
}

template <class Port>
inline constexpr int unbound_size = PortSize<Port>::value == any_size ? 0 : PortSize<Port>::value;

template <class T>
struct IsContinuous : std::false_type {};
template <int n>
struct IsContinuous<State<n>> : std::true_type {};

}  // namespace detail

/// Form of a parameter of C++ type T in a file, and its conversion from and to a Value.
template <class T>
struct ParameterAccess {
  static_assert(std::is_enum_v<T>,
                "a parameter is a double, int64, bool, enum, Text, FilePath, Numbers, ...");
  static constexpr ParameterKind kind = ParameterKind::word;
  static void set(T& member, const Value& value) { member = static_cast<T>(std::get<double>(value.content)); }
  static Value get(const T& member) { return {static_cast<double>(member)}; }
};

template <class T, ParameterKind parameter_kind, class Stored = T>
struct StoredAs {
  static constexpr ParameterKind kind = parameter_kind;
  static void set(T& member, const Value& value) { member = static_cast<T>(std::get<Stored>(value.content)); }
  static Value get(const T& member) { return {static_cast<Stored>(member)}; }
};

template <>
struct ParameterAccess<double> : StoredAs<double, ParameterKind::number> {};
template <>
struct ParameterAccess<std::int64_t> : StoredAs<std::int64_t, ParameterKind::integer, double> {};
template <>
struct ParameterAccess<bool> : StoredAs<bool, ParameterKind::flag> {};

/// A list of numbers, stored as a vector in a Value.
template <class List, ParameterKind parameter_kind>
struct StoredAsVector {
  static constexpr ParameterKind kind = parameter_kind;
  static void set(List& member, const Value& value) {
    const auto& vector = std::get<Eigen::VectorXd>(value.content);
    member = List(Numbers(vector.data(), vector.size()));
  }
  static Value get(const List& member) {
    return {Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(member.data(), member.size()))};
  }
};

template <>
struct ParameterAccess<Numbers> : StoredAsVector<Numbers, ParameterKind::vector> {};
template <>
struct ParameterAccess<PerElement> : StoredAsVector<PerElement, ParameterKind::per_element> {};

template <>
struct ParameterAccess<Text> {
  static constexpr ParameterKind kind = ParameterKind::text;
  static void set(Text& member, const Value& value) { member = Text(*value.text()); }
  static Value get(const Text& member) { return {std::string(member)}; }
};

template <>
struct ParameterAccess<Matrix> {
  static constexpr ParameterKind kind = ParameterKind::matrix;
  static void set(Matrix& member, const Value& value) {
    const auto& matrix = std::get<Eigen::MatrixXd>(value.content);
    member = Matrix(matrix.rows(), matrix.cols(), Numbers(matrix.data(), matrix.size()));
  }
  static Value get(const Matrix& member) {
    return {Eigen::MatrixXd(
        Eigen::Map<const Eigen::MatrixXd>(member.elements().data(), member.rows(), member.columns()))};
  }
};

template <>
struct ParameterAccess<FilePath> {
  static constexpr ParameterKind kind = ParameterKind::file;
  static void set(FilePath& member, const Value& value) { member = FilePath(*value.text()); }
  static Value get(const FilePath& member) { return {member.string()}; }
};

template <>
struct ParameterAccess<std::vector<std::string>> {
  static constexpr ParameterKind kind = ParameterKind::texts;
  static void set(std::vector<std::string>& member, const Value& value) {
    member.clear();
    for (const Value& item : *value.list()) member.push_back(*item.text());
  }
  static Value get(const std::vector<std::string>& member) {
    Value::List list;
    for (const std::string& text : member) list.push_back({text});
    return {list};
  }
};

template <>
struct ParameterAccess<Tree> {
  static constexpr ParameterKind kind = ParameterKind::tree;
  static void set(Tree& member, const Value& value) { member = Tree(value); }
  static Value get(const Tree& member) { return member.value(); }
};

/// Access to the numbers of a member of type T that prepare() computes. Types of a block have a
/// specialisation beside its declaration.
template <class T>
struct PreparedParts;

template <>
struct PreparedParts<double> {
  static constexpr bool by_element = false;
  static Index count(double) { return 1; }
  static std::string text(Index) { return ""; }
  static void put(double& member, const double* numbers, Index) { member = *numbers; }
};

/// Prepared element by element, each in a block of one element, which needs no heap memory.
template <>
struct PreparedParts<PerElement> {
  static constexpr bool by_element = true;
  static Index count(const PerElement& member) { return member.size(); }
  static std::string text(Index) { return ".data()[0]"; }
  static void put(PerElement& member, const double* numbers, Index count) {
    member = PerElement(Numbers(numbers, count));
  }
};

template <>
struct PreparedParts<Numbers> {
  static constexpr bool by_element = false;
  static Index count(const Numbers& member) { return member.size() <= Numbers::capacity ? member.size() : 0; }
  static std::string text(Index k) { return "[" + std::to_string(k) + "]"; }
  static void put(Numbers& member, const double* numbers, Index count) { member = Numbers(numbers, count); }
};

// Properties of a block in its declaration; the following types are those of its members.

struct BlockOptions {
  std::string doc;
  std::string source = "";
  Timing timing = Timing::inherited;
  /// Reason why a real-time loop refuses the block: "reads a file at every step". Empty if no step allocates,
  /// locks, makes a system call or has an unbounded duration.
  std::string not_real_time = "";
  /// Name of the input that has the delay time [s] of an exact delay. The first output is the first input,
  /// which has no feedthrough, this time ago. Linear analyses put exp(-s T) in the place of the block.
  std::string delayed_by = "";
  /// Block to use with a period in place of this continuous one: "DiscretePID". Empty without one.
  std::string discrete = "";
  Symbol symbol{};
  /// The outputs are constant between crossings.
  bool steady = false;
  /// Lets a block with memory act at located events as well, if it has no `every`. It must not rely on its
  /// period.
  bool at_events = false;
  /// Calls update() at the last row of a run, too, where no step follows, since it judges the present values
  /// and raises diagnostics. Nothing reads what else it changes there.
  bool at_end = false;
  /// Promises that outputs jump only where an input or a reset does, never by time alone.
  bool smooth = false;
  /// Algebraic loops through the block are solved for its outputs. The iteration begins at the values that
  /// start() sets.
  bool torn = false;
  /// Header that declares the struct, relative to the folder of the declaring source. Needed for a header of
  /// another name or folder.
  std::string header = "";
};

struct ParameterOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  std::optional<double> above{}, below{}, at_least{}, at_most{};
  std::vector<std::string> words{};
  bool required = false;
  /// Sizes or connections of the block depend on the number. A change needs a new plan, and a generated
  /// program keeps the value.
  bool structural = false;
  /// Keys of a tree whose texts, and those of a nested map, are expressions; "to." for the nested map alone;
  /// {""} where the text itself is one. Names in them are parameters of the diagram, except for names that
  /// the block defines: its inputs, the list `variables`, u1, u2, .. and time.
  std::vector<std::string> formulas{};
};

struct InputOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  bool feedthrough = true;
  bool optional = false;
  bool multiply_units = false;
  /// The elements are added, or compared with each other, so they must be in one unit.
  bool one_unit = false;
};

struct OutputOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
};

struct StateOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  double initial = 0.0;
  bool settable = true;
  /// The state is 0 before the first instant and 1 afterwards. A linear analysis treats it as 1.
  bool marks_start = false;
  /// The state is a mode that outputs_at_instant() stores. The block keeps the rate of its inputs.
  bool mode = false;
};

struct DiagnosticOptions {
  std::string doc;
  bool ends_run = false;
  bool is_fault = true;  ///< false: the run that it ends is complete, as with `stop_when`
};

namespace detail {

template <class Block>
void find_phases(BlockType& type) {
  if constexpr (requires(Block b) { b.outputs(); }) type.run_outputs = kernels_of<Block, &Block::outputs>();
  if constexpr (requires(Block b) { b.outputs_at_instant(); })
    type.run_outputs_at_instant = kernels_of<Block, &Block::outputs_at_instant>();
  if constexpr (requires(Block b) { b.derivatives(); })
    type.run_derivatives = kernels_of<Block, &Block::derivatives>();
  if constexpr (requires(Block b) { b.update(); }) type.run_update = kernels_of<Block, &Block::update>();
  if constexpr (requires(Block b) { b.update_at_event(); })
    type.run_update_at_event = kernels_of<Block, &Block::update_at_event>();
  if constexpr (requires(Block b) { b.update_before_instant(); })
    type.run_update_before_instant = kernels_of<Block, &Block::update_before_instant>();
}

template <class Block>
void find_events(BlockType& type) {
  if constexpr (requires(const Block b, Crossings& zero) { b.crossings(zero); })
    type.run_crossings = [](const void* block, double* numbers) {
      Crossings zero(numbers);
      Called<const Block>(block)->crossings(zero);
    };
  if constexpr (requires(const Block b) { b.next_edge(); })
    type.run_next_edge = [](const void* block) -> double { return Called<const Block>(block)->next_edge(); };
}

template <class Block>
void find_set_up(BlockType& type) {
  if constexpr (requires(Block b, Configure & is) { b.configure(is); })
    type.configure = [](void* block, Configure& is) { Called<Block>(block)->configure(is); };
  if constexpr (requires(Block b) { b.prepare(); })
    type.prepare = [](void* block) { Called<Block>(block)->prepare(); };
  if constexpr (requires(const Block b, Outline& lines) { b.outline(lines); })
    type.outline = [](const void* block, Outline& lines) { Called<const Block>(block)->outline(lines); };
  if constexpr (requires(Block b) { b.start(); })
    type.start = [](void* block) { Called<Block>(block)->start(); };
}

/// Detects the functions that a block's struct defines.
template <class Block>
void find_functions(BlockType& type) {
  find_phases<Block>(type);
  find_events<Block>(type);
  find_set_up<Block>(type);
}

}  // namespace detail

/// Tag of a derived member that does not depend on the number of any parameter.
enum class From { no_number };

namespace detail {

/// Returns BlockType::header of a struct declared in a source, which may name the header.
std::string header_of(std::string_view source, const std::string& named, std::string_view struct_name);

template <auto... from>
std::optional<std::vector<std::string>> names_of() {
  if constexpr (sizeof...(from) == 0) {
    return {};
  } else if constexpr ((std::is_same_v<decltype(from), From> || ...)) {
    return std::vector<std::string>{};
  } else {
    return std::vector<std::string>{std::string(member_name<from>())...};
  }
}

}  // namespace detail

/// Collects the declaration of a block; `declare(Declare<Block>&)` names each member once.
///
/// Units: "N" or "mm/s" (numbers inside are SI), "1" for none, "*" for any. Unit variables are determined by
/// the wires: "'u" (a name after a quote), "'u s", "'k 'u", "'a/'b", "'u^0.5".
///
/// Shapes: a number, a letter that denotes the same size in the whole block, or "m x n" for matrices of m
/// rows in column-major order. A port with one letter passes matrices as their elements; all ports of that
/// letter have the same rows and columns. The elements of a list have one shape. With the shape "+n" their
/// elements together are n, with "m x +n" their columns.
template <class Block>
class Declare {
 public:
  Declare() {
    type_.bytes = sizeof(Block);
    type_.alignment = alignof(Block);
    type_.construct = detail::construct<Block>;
    type_.copy = detail::copy<Block>;
    type_.destroy = [](void* block) { detail::Called<Block>(block)->~Block(); };
    detail::find_functions<Block>(type_);
  }

  void block(std::string name, BlockOptions options,
             const char* file = __builtin_FILE(),  // of the declaration; clang 14 lacks std::source_location
             int line = __builtin_LINE()) {
    type_.name = std::move(name);
    type_.struct_name = detail::type_name<Block>();
    type_.header = detail::header_of(file, options.header, type_.struct_name);
    type_.declared_at = std::string(file) + ":" + std::to_string(line);
    type_.doc = std::move(options.doc);
    type_.source = std::move(options.source);
    type_.not_real_time = std::move(options.not_real_time);
    type_.delayed_by = std::move(options.delayed_by);
    type_.discrete = std::move(options.discrete);
    type_.symbol = std::move(options.symbol);
    type_.steady = options.steady;
    type_.at_events = options.at_events;
    type_.at_end = options.at_end;
    type_.smooth = options.smooth;
    type_.torn = options.torn;
    if (options.timing != Timing::inherited) type_.timing = options.timing;
  }

  template <auto member>
  void parameter(ParameterOptions is) {
    using Access = ParameterAccess<MemberType<member>>;
    ParameterSpec spec{std::string(member_name<member>()),
                       Access::kind,
                       is.unit,
                       is.shape,
                       is.doc,
                       {is.above, is.below, is.at_least, is.at_most},
                       is.words,
                       is.required,
                       is.structural,
                       is.formulas};
    if (Access::kind == ParameterKind::per_element && spec.shape.empty()) spec.shape.assign(1, 'n');
    spec.set = [](void* block, const Value& value) { Access::set(of<member>(block), value); };
    spec.get = [](const void* block) { return Access::get(static_cast<const Block*>(block)->*member); };
    if constexpr (has_literal<MemberType<member>>) {
      derived<member>();
      spec.member = static_cast<int>(type_.members.size()) - 1;
    }
    type_.parameters.push_back(std::move(spec));
  }

  /// Declares a member that configure() or prepare() compute and a run reads. `from` names the parameters
  /// whose numbers it depends on: all parameters if omitted, From::no_number if only wires, words and sizes
  /// matter. These parameters are fixed in a generated program, which cannot compute the member again.
  template <auto member, auto... from>
  void derived() {
    type_.members.push_back({std::string(member_identifier<member>()),
                             [](const void* block, LiteralWriter& writer) {
                               return Literal<MemberType<member>>::text(
                                   static_cast<const Block*>(block)->*member, writer);
                             },
                             {},
                             detail::names_of<from...>()});
  }

  /// Declares a member of type Index that holds a size, by its letter in the declared shapes: the rows m of a
  /// port "m x n". It is set before prepare().
  template <auto member>
  void size(std::string symbol) {
    derived<member, From::no_number>();
    type_.sizes.push_back(
        {std::move(symbol), [](void* block, Eigen::Index elements) { of<member>(block) = elements; }});
  }

  /// Declares a derived member that prepare() computes inline in the header, so that generated code can
  /// compute it again where a parameter changes. `from` is as for derived(). It applies where the member has
  /// too many numbers for a program without heap memory.
  template <auto member, auto... from>
  void prepared() {
    using Parts = PreparedParts<MemberType<member>>;
    derived<member, from...>();
    type_.members.back().prepared = {
        [](const void* block) { return Parts::count(static_cast<const Block*>(block)->*member); },
        [](Eigen::Index k) { return Parts::text(k); },
        [](void* block, const double* numbers, Eigen::Index count) {
          Parts::put(of<member>(block), numbers, count);
        },
        Parts::by_element};
  }

  template <auto member>
  void input(InputOptions is) {
    using Port = MemberType<member>;
    InputSpec spec{std::string(member_name<member>()),
                   is.unit,
                   detail::shape_of<Port>(is.shape),
                   is.doc,
                   std::string(member_identifier<member>()),
                   is.feedthrough,
                   is.optional,
                   std::is_same_v<Port, Inputs>,
                   is.multiply_units,
                   is.one_unit};
    if constexpr (std::is_same_v<Port, Inputs>) {
      spec.bind_list = [](void* block, const Inputs::Element* elements, Eigen::Index count) {
        of<member>(block).bind(elements, count);
      };
      spec.unbind = [](void* block) { of<member>(block).bind(nullptr, 0); };
    } else {
      spec.bind = [](void* block, const double* data, Eigen::Index size) {
        of<member>(block).bind(data, size);
      };
      spec.unbind = [](void* block) { of<member>(block).bind(nullptr, detail::unbound_size<Port>); };
    }
    type_.inputs.push_back(std::move(spec));
  }

  template <auto member>
  void output(OutputOptions is) {
    type_.outputs.push_back(
        {std::string(member_name<member>()), is.unit, detail::shape_of<MemberType<member>>(is.shape), is.doc,
         std::string(member_identifier<member>()), "",
         [](void* block, double* data, Eigen::Index size) { of<member>(block).bind(data, size); }});
  }

  /// Declares an output that is a continuous state. It needs no computation and no memory of its own, unless
  /// the block also has outputs() and does not skip it in configure().
  template <auto member, auto state>
  void output(OutputOptions is) {
    output<member>(std::move(is));
    type_.outputs.back().state = std::string(member_name<state>());
  }

  template <auto member>
  void state(StateOptions is) {
    using Kind = MemberType<member>;
    constexpr bool continuous = detail::IsContinuous<Kind>::value;
    StateSpec spec{std::string(member_name<member>()),
                   is.unit,
                   detail::shape_of<Kind>(is.shape),
                   is.doc,
                   std::string(member_identifier<member>()),
                   continuous,
                   is.settable,
                   is.initial,
                   is.marks_start};
    spec.bind = [](void* block, double* data, double* derivative, Eigen::Index size) {
      of<member>(block).bind(data, size);
      if constexpr (continuous) of<member>(block).derivative.bind(derivative, size);
      static_cast<void>(derivative);
    };
    if (type_.timing == Timing::inherited && !is.mode) type_.timing = Timing::discrete;
    if (continuous) type_.timing = Timing::continuous;
    type_.states.push_back(std::move(spec));
  }

  /// Declares a diagnostic. `detail`, a std::string(const Block&), returns names and numbers for the message.
  /// It may read parameters and discrete states, which still have their values of the instant at which it was
  /// raised.
  template <auto member, auto detail = nullptr>
  void diagnostic(DiagnosticOptions is) {
    type_.diagnostics.push_back({std::string(member_name<member>()), is.doc,
                                 std::string(member_identifier<member>()), is.ends_run, is.is_fault,
                                 [](void* block, double* first) { of<member>(block).bind(first); }});
    if constexpr (!std::is_null_pointer_v<decltype(detail)>)
      type_.diagnostics.back().detail = [](const void* block) {
        return detail(*stepwire::detail::Called<const Block>(block));
      };
  }

  /// Declares a function that crosses zero where the block's behaviour changes abruptly, with the elements of
  /// `shape`. crossings() adds the values row by row. It reads only these inputs.
  template <auto... inputs>
  void crossing(std::string doc, std::string shape = "n") {
    type_.crossings.push_back({std::move(doc), std::move(shape), {std::string(member_name<inputs>())...}});
  }

  /// Declares the crossing of an input of one element: it becomes true or false. It has no number where the
  /// input is not connected; crossings() adds it by add_connected().
  template <auto input>
  void crossing_of(std::string doc) {
    crossing<input>(std::move(doc), "1");
    type_.crossings.back().if_connected = true;
  }

  /// Declares a member that is bound to the time, or to the time between updates.
  template <auto member>
  void clock() {
    const std::string name(member_identifier<member>());
    if constexpr (std::is_same_v<MemberType<member>, Time>) {
      type_.clocks.push_back(
          {name, [](void* block, const double* time) { of<member>(block).bind(time); }, nullptr});
      if (type_.timing == Timing::inherited) type_.timing = Timing::continuous;
    } else {
      type_.clocks.push_back(
          {name, nullptr, [](void* block, double period) { of<member>(block).bind(period); }});
    }
  }

  /// Declares a named set of values: `set` changes the defaults of parameters, and keys of the file override
  /// them.
  template <void (*set)(Block&)>
  void preset(std::string name, std::string doc) {
    type_.presets.push_back(
        {std::move(name), std::move(doc), [](void* block) { set(*detail::Called<Block>(block)); }});
  }

  /// True where one of the states declared so far is continuous.
  bool has_continuous_state() const { return type_.has_continuous_state(); }

  BlockType take() { return std::move(type_); }

 private:
  template <auto member>
  using MemberType = std::remove_cvref_t<decltype(std::declval<Block&>().*member)>;

  template <auto member>
  static auto& of(void* block) {
    return static_cast<Block*>(block)->*member;
  }

  BlockType type_;
};

}  // namespace stepwire
