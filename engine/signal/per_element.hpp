#pragma once

#include <Eigen/Core>

namespace stepwire {

/// A parameter with one number for each element of a signal. A file may give a single number for all of them;
/// once the diagram is planned it has as many elements as the signal.
class PerElement : public Eigen::ArrayXd {
 public:
  PerElement(double all) : Eigen::ArrayXd(Eigen::ArrayXd::Constant(1, all)) {}
  explicit PerElement(Eigen::ArrayXd elements) : Eigen::ArrayXd(std::move(elements)) {}
};

}  // namespace stepwire
