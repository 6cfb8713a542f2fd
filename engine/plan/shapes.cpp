#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <unordered_map>

#include "engine/plan/draft.hpp"
#include "engine/plan/sizes.hpp"

namespace stepwire {

namespace {

/// Of all ports and states together: beyond, a delay or a chain of Mux blocks was meant to be shorter.
constexpr Eigen::Index most_numbers = Eigen::Index{1} << 26;

/// a b, but no more than what is refused anyway.
Eigen::Index bounded_product(Eigen::Index a, Eigen::Index b) {
  const double product = static_cast<double>(a) * static_cast<double>(b);
  return product > static_cast<double>(most_numbers) ? most_numbers + 1 : a * b;
}

/// Finds the size of every port and state. A list input takes elements of one size or of one element; with
/// the shape
/// "+m" each element has its own size and m is their sum.
class Shapes {
 public:
  explicit Shapes(Draft& draft) : draft_(draft), symbols_(draft.blocks.size()) {}

  void run() {
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) declare(i);
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) connect(i);
    settle();
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) {
      check_elements(i);
      refuse_small(i);
    }
    for (std::size_t i = 0; i < draft_.blocks.size(); ++i) store(i);
  }

 private:
  /// The number behind a letter or a literal of one block.
  int symbol(std::size_t block, const std::string& text) {
    for (const auto& [name, size] : symbols_[block])
      if (name == text) return size;
    const int size = sizes_.add();
    symbols_[block].emplace_back(text, size);
    Eigen::Index literal = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), literal).ec == std::errc())
      sizes_.set(size, literal);
    return size;
  }

  void declare(std::size_t index) {
    const DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, elements] : draft_.blocks[index].sizes) sizes_.set(symbol(index, name), elements);
    for (std::size_t p = 0; p < block.type().parameters.size(); ++p) declare_parameter(index, block, p);
    for (const InitialValue& initial : block.initial) {
      const StateSpec& spec = block.type().states[static_cast<std::size_t>(initial.state)];
      if (initial.value.size() > 1)
        require(index, spec.shape, initial.value.size(), initial.origin, initial.value.size(),
                "the initial value");
    }
  }

  void declare_parameter(std::size_t index, const DiagramBlock& block, std::size_t p) {
    const ParameterSpec& spec = block.type().parameters[p];
    if (spec.shape.empty()) return;
    const Value value = spec.get(block.block.get());
    const Mark mark = block.parameter_marks[p].line ? block.parameter_marks[p] : block.origin.mark;
    const Origin origin{block.origin.scope, mark};
    if (const auto* vector = std::get_if<Eigen::VectorXd>(&value.content)) {
      if (spec.kind == ParameterKind::per_element && vector->size() == 1) return;
      require(index, spec.shape, vector->size(), origin, vector->size(), "'" + spec.name + "'");
    } else if (const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content)) {
      const std::size_t times = spec.shape.find(" x ");
      if (times == std::string::npos || matrix->size() == 0) return;
      require(index, spec.shape.substr(0, times), matrix->rows(), origin, matrix->rows(),
              "the number of rows of '" + spec.name + "'");
      require(index, spec.shape.substr(times + 3), matrix->cols(), origin, matrix->cols(),
              "the number of columns of '" + spec.name + "'");
    }
  }

  void require(std::size_t block, const std::string& shape, Eigen::Index elements, const Origin& origin,
               Eigen::Index shown, const std::string& what) {
    const int size = symbol(block, shape);
    if (!sizes_.set(size, elements))
      draft_.report.add(origin, draft_.diagram().blocks[block].name,
                        fmt::format("{} has {} elements; {} would fit", what, shown, *sizes_.value(size)));
  }

  int output_size(const Source& source) {
    const auto block = static_cast<std::size_t>(source.block);
    return symbol(block, draft_.type(block).outputs[static_cast<std::size_t>(source.output)].shape);
  }

  void connect(std::size_t index) {
    const DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (spec.list) {
        lists_.push_back({index, i});
        continue;
      }
      for (const Source& source : block.inputs[i]) connect_one(index, spec, source);
    }
  }

  void connect_one(std::size_t index, const InputSpec& spec, const Source& source) {
    const int wanted = symbol(index, spec.shape);
    const std::string subject = draft_.diagram().blocks[index].name + "." + spec.name;
    if (source.block < 0) {
      if (source.constant.size() > 1 && !sizes_.set(wanted, source.constant.size()))
        draft_.report.add(
            source.origin, subject,
            fmt::format("has {} numbers; {} would fit", source.constant.size(), *sizes_.value(wanted)));
    } else if (const int given = output_size(source); !sizes_.join(given, wanted)) {
      draft_.report.add(
          source.origin, subject,
          fmt::format("'{}' has {} elements, but {} takes {}; join or pick elements with Mux or Select",
                      name_of(source), *sizes_.value(given), subject, *sizes_.value(wanted)));
    }
  }

  std::string name_of(const Source& source) const {
    const DiagramBlock& block = draft_.plan.diagram.blocks[static_cast<std::size_t>(source.block)];
    const auto& outputs = block.type().outputs;
    return outputs.size() == 1 ? block.name
                               : block.name + "." + outputs[static_cast<std::size_t>(source.output)].name;
  }

  std::optional<Eigen::Index> size_of(const Source& source) {
    return source.block < 0 ? std::optional(source.constant.size()) : sizes_.value(output_size(source));
  }

  /// Lists follow from their elements. What no open list could tell any more is a scalar, and where lists
  /// wait for each other (a loop), so is one of them.
  void settle() {
    while (settle_lists()) {
    }
    settle_scalars();
    while (settle_lists() || settle_one_scalar()) {
    }
  }

  int size_of_list(std::size_t index, std::size_t input) {
    const std::string& shape = draft_.type(index).inputs[input].shape;
    return symbol(index, shape.starts_with('+') ? shape.substr(1) : shape);
  }

  void settle_scalars() {
    std::vector<int> waiting;
    for (const auto& [index, input] : lists_) waiting.push_back(size_of_list(index, input));
    std::vector<bool> waits(static_cast<std::size_t>(sizes_.count()), false);
    for (int size : waiting) waits[static_cast<std::size_t>(sizes_.root(size))] = true;
    for (int size = 0; size < sizes_.count(); ++size)
      if (!sizes_.value(size) && !waits[static_cast<std::size_t>(sizes_.root(size))]) sizes_.set(size, 1);
  }

  bool settle_lists() {
    bool progress = false;
    std::erase_if(lists_, [&](const auto& list) {
      const bool done = settle_list(list.first, list.second);
      progress = progress || done;
      return done;
    });
    return progress;
  }

  bool settle_list(std::size_t index, std::size_t input) {
    const DiagramBlock& block = draft_.diagram().blocks[index];
    const InputSpec& spec = block.type().inputs[input];
    const bool total = spec.shape.starts_with('+');
    Eigen::Index sum = 0, most = 1;
    bool open = false;
    for (const Source& source : block.inputs[input]) {
      const auto size = size_of(source);
      open = open || !size;
      sum = std::min(sum + size.value_or(0), most_numbers + 1);
      most = std::max(most, size.value_or(1));
    }
    if (open && (total || most == 1)) return false;
    const int own = size_of_list(index, input);
    const Eigen::Index size = total ? sum : std::max(most, sizes_.value(own).value_or(1));
    const std::string subject = block.name + "." + spec.name;
    if (sizes_.set(own, size)) return true;
    refused_.insert({index, input});
    draft_.report.add({block.origin.scope, block.input_marks[input]}, subject,
                      fmt::format("has {} elements; {} would fit", size, *sizes_.value(own)));
    return true;
  }

  /// At the end, since an element's own size may come to be known only after that of its list.
  void check_elements(std::size_t index) {
    const DiagramBlock& block = draft_.diagram().blocks[index];
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      const InputSpec& spec = block.type().inputs[i];
      if (!spec.list || spec.shape.starts_with('+') || refused_.contains({index, i})) continue;
      const Eigen::Index size = sizes_.value(size_of_list(index, i)).value_or(1);
      for (const Source& source : block.inputs[i]) check_element(source, size, block.name + "." + spec.name);
    }
  }

  void check_element(const Source& source, Eigen::Index size, const std::string& subject) {
    const auto given = size_of(source);
    if (!given || *given == 1 || *given == size) return;
    draft_.report.add(
        source.origin, subject,
        fmt::format("{} has {} elements, but others in this list have {}; all must have the same, or one",
                    source.block < 0 ? "this" : "'" + name_of(source) + "'", *given, size));
  }

  bool settle_one_scalar() {
    for (; next_open_ < sizes_.count(); ++next_open_)
      if (!sizes_.value(next_open_)) return sizes_.set(next_open_, 1);
    return false;
  }

  void refuse_small(std::size_t index) {
    const DiagramBlock& block = draft_.diagram().blocks[index];
    for (const auto& [name, least] : draft_.blocks[index].least_sizes) {
      const Eigen::Index size = sizes_.value(symbol(index, name)).value_or(1);
      if (size < least)
        draft_.report.add(block.origin, block.name,
                          fmt::format("is fed {} elements; it needs at least {}", size, least));
    }
  }

  void store(std::size_t index) {
    DiagramBlock& block = draft_.diagram().blocks[index];
    Draft::Block& made = draft_.blocks[index];
    const auto factor = [&](const std::string& name) {
      return sizes_.value(symbol(index, name)).value_or(1);
    };
    const auto size = [&](const std::string& shape) {  // "k x n": k rows of n elements, one behind the other
      const std::size_t times = shape.find(" x ");
      return times == std::string::npos
                 ? factor(shape)
                 : bounded_product(factor(shape.substr(0, times)), factor(shape.substr(times + 3)));
    };
    for (const OutputSpec& spec : block.type().outputs) made.output_sizes.push_back(size(spec.shape));
    for (const StateSpec& spec : block.type().states) made.state_sizes.push_back(size(spec.shape));
    for (const InputSpec& spec : block.type().inputs)
      made.input_sizes.push_back(
          size(spec.list && spec.shape.starts_with('+') ? spec.shape.substr(1) : spec.shape));
    if (!fits(block, made)) return;
    for (const ParameterSpec& spec : block.type().parameters)
      if (spec.kind == ParameterKind::per_element) expand(block, spec, size(spec.shape));
  }

  /// Refuses the block with which it becomes too much.
  bool fits(const DiagramBlock& block, const Draft::Block& made) {
    if (total_ > most_numbers) return false;
    Eigen::Index own = 0;
    for (const auto* sizes : {&made.output_sizes, &made.state_sizes, &made.input_sizes})
      for (Eigen::Index size : *sizes) own += std::clamp<Eigen::Index>(size, 0, most_numbers + 1);
    total_ += own;
    if (total_ <= most_numbers) return true;
    draft_.report.add(
        block.origin, block.name,
        fmt::format("needs {}{} numbers for its ports and states; all blocks together may have {}",
                    own > most_numbers ? "more than " : "", std::min(own, most_numbers), most_numbers));
    return false;
  }

  static void expand(DiagramBlock& block, const ParameterSpec& spec, Eigen::Index size) {
    if (size == 1) return;
    const Value value = spec.get(block.block.get());
    const auto& elements = std::get<Eigen::VectorXd>(value.content);
    if (elements.size() == 1)
      spec.set(block.block.get(), {Eigen::VectorXd(Eigen::VectorXd::Constant(size, elements[0]))});
  }

  Draft& draft_;
  Sizes sizes_;
  std::vector<std::vector<std::pair<std::string, int>>> symbols_;
  std::vector<std::pair<std::size_t, std::size_t>> lists_;
  std::set<std::pair<std::size_t, std::size_t>> refused_;  ///< lists of which enough has been said
  int next_open_ = 0;
  Eigen::Index total_ = 0;
};

}  // namespace

void plan_shapes(Draft& draft) {
  Shapes(draft).run();
}

}  // namespace stepwire
