#pragma once

#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/model/block/block.hpp"
#include "engine/model/block/block_type.hpp"
#include "engine/model/block/declare_options.hpp"
#include "engine/model/block/find_functions.hpp"
#include "engine/model/block/kernels.hpp"
#include "engine/model/block/literal.hpp"
#include "engine/model/block/member_name.hpp"
#include "engine/model/block/parameter_access.hpp"
#include "engine/model/block/port_traits.hpp"
#include "engine/model/block/prepared_parts.hpp"

namespace stepwire {

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
                   is.multiply_units};
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
    if (type_.timing == Timing::inherited) type_.timing = Timing::discrete;
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
