#pragma once

#include <map>
#include <string>

#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/codegen/compiler.hpp"

namespace stepwire::random {

/// A diagram as a unit of FMI.
struct MadeUnit {
  std::string file;       ///< the archive
  std::string refused{};  ///< the reason for which it cannot be exported; else empty
  std::string problem{};  ///< errors of the compiler; else empty
  bool exchanges = false, done = false;
};

/// Units of many diagrams, which are compiled on all cores.
class BatchUnits {
 public:
  /// The unit of a plan, of FMI 2 or 3; nullptr before make_all(), which the plan has to outlive.
  const MadeUnit* unit(const plan::Plan& plan, int version);
  void make_all(const codegen::Compiler& compiler);
  void clear() { wanted_.clear(); }

 private:
  struct Wanted {
    const plan::Plan* plan = nullptr;
    int version = 3;
    MadeUnit made{};
  };

  void make(Wanted& wanted, const codegen::Compiler& compiler);

  subprocess::ScratchFolder folder_;
  std::map<std::string, Wanted> wanted_;  ///< by version and flattened file
  std::size_t count_ = 0;                 ///< of archives
};

}  // namespace stepwire::random
