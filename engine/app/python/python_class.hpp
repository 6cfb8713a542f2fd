#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/app/python/raised.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {
struct BlockType;
}

namespace stepwire::python {

/// What the methods of a block are called with.
enum class Source { time, period, input, state, memory };

/// One argument of a method.
struct Argument {
  Source source = Source::time;
  std::size_t index = 0;  ///< among the inputs, the continuous states or the discrete ones
};

/// A method of a class: its arguments in their order.
struct Method {
  bool exists = false;
  std::vector<Argument> arguments{};
  std::string shown{};  ///< "Drag.outputs"
};

/// A class of Python's as a kind of block: what the declaration of its ports says.
struct PythonClass {
  struct Port {
    std::string name, unit, shape;
    bool feedthrough = true;
    double initial = 0.0;
    Eigen::Index rows = 0;  ///< of a matrix; 0 for a vector
  };
  struct Parameter {
    std::string name, unit, doc;
    Value value{};  ///< the default: its kind is that of the parameter
    bool required = false;
  };

  std::string name, doc, place;  ///< place: where a person finds it, "cart.Drag"
  Held made;                     ///< the class
  std::vector<Port> inputs, outputs, states, memory;
  std::vector<Parameter> parameters;
  Method output_method, slope_method, update_method;
  std::shared_ptr<Raised> raised;  ///< takes what its methods raise
};

/// The type of its blocks. Throws std::invalid_argument where it has more of something than a block may have.
BlockType type_of(std::shared_ptr<const PythonClass> made);

}  // namespace stepwire::python
