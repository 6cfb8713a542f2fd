#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/raised.hpp"
#include "engine/model/block/block.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {
struct BlockType;
}

namespace stepwire::python {

/// Kinds of arguments of a block's methods.
enum class Source { time, period, input, state, memory };

/// Argument of a method.
struct Argument {
  Source source = Source::time;
  std::size_t index = 0;  ///< index among the inputs, the continuous states or the discrete states
};

/// Method of a class, with its arguments in order.
struct Method {
  bool exists = false;
  std::vector<Argument> arguments{};
  std::string shown{};  ///< name for messages, "Drag.outputs"
};

/// Python class as a block type: the declarations of its ports and methods.
struct PythonClass {
  struct Port {
    std::string name, unit, shape;
    bool feedthrough = true;
    double initial = 0.0;
    Eigen::Index rows = 0;  ///< rows of a matrix; 0 for a vector
  };
  struct Parameter {
    std::string name, unit, doc;
    Value value{};  ///< default value; its kind is the kind of the parameter
    bool required = false;
  };

  std::string name, doc, place;  ///< `place` is the qualified name for messages, "cart.Drag"
  Held made;                     ///< the Python class
  std::vector<Port> inputs, outputs, states, memory;
  std::vector<Parameter> parameters;
  Method output_method, slope_method, update_method;
  std::shared_ptr<Raised> raised;  ///< store of exceptions from its methods
};

/// Returns the block type. Throws std::invalid_argument if the class exceeds a limit of PythonBlock.
BlockType type_of(std::shared_ptr<const PythonClass> made);

class Instance;

/// Block whose methods are those of a Python object. Each run makes its own object at the start.
struct PythonBlock {
  static constexpr std::size_t most = 16;  ///< largest number of ports, states or parameters of each kind

  std::shared_ptr<const PythonClass> of{};
  std::array<Input<>, most> inputs{};
  std::array<Output<>, most> results{};
  std::array<State<>, most> states{};
  std::array<DiscreteState<>, most> memory{};
  std::array<Value, most> values{};  ///< parameter values
  Diagnostic failed{};
  Time t{};
  Period period{};
  double now = 0.0, between = 0.0;       ///< copies of t and period, as arguments of the methods
  std::shared_ptr<Instance> instance{};  ///< nullptr in a copy.
  std::string why{};                     ///< Reason of the failure; empty before it.

  PythonBlock() = default;
  /// Copies all but the object, which start() makes.
  PythonBlock(const PythonBlock& other);
  PythonBlock& operator=(const PythonBlock&) = delete;

  void outputs();
  void derivatives();
  void update();
  void start();
  /// Constructs the object once, so that an exception in its __init__ is reported at loading.
  void configure(Configure& is);
  static void declare(Declare<PythonBlock>& is);

 private:
  void connect(std::size_t method);
  void call(std::size_t method);
  void fail();
};

}  // namespace stepwire::python
