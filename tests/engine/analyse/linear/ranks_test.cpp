// Systems whose ranks are known by how they are made.
#include "engine/analyse/linear/state_space.hpp"

#include <Eigen/QR>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace stepwire::linear {

namespace {

class RandomSystems {
 public:
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd made(rows, columns);
    for (double& number : made.reshaped()) number = uniform_(generator_);
    return made;
  }
  Eigen::Index from_one_to(Eigen::Index most) {
    return 1 + static_cast<Eigen::Index>(generator_() % static_cast<std::uint64_t>(most));
  }

  enum class Kind { full, chain, modes };

  /// Of n states with `reached` ones, turned or in any order, and with states in units that are `decades`
  /// apart. A chain is driven at its first state only; modes are driven each by itself.
  StateSpace system(Eigen::Index n, Eigen::Index reached, Eigen::Index inputs, int decades,
                    Kind kind = Kind::full, bool turned = true) {
    Eigen::MatrixXd A = matrix(n, n), B = Eigen::MatrixXd::Zero(n, inputs);
    A.bottomLeftCorner(n - reached, reached).setZero();
    B.topRows(reached) = matrix(reached, inputs);
    if (kind != Kind::full) A.topLeftCorner(reached, reached).setZero();
    for (Eigen::Index i = 0; i < reached && kind != Kind::full; ++i)
      A(i, i) = kind == Kind::modes ? -1.0 - static_cast<double>(i) : -1.0;
    for (Eigen::Index i = 1; i < reached && kind == Kind::chain; ++i) {
      A(i, i - 1) = 1.5;
      B.row(i).setZero();
    }
    Eigen::MatrixXd turn = Eigen::HouseholderQR<Eigen::MatrixXd>(matrix(n, n)).householderQ();
    if (!turned) turn = Eigen::MatrixXd::Identity(n, n).rowwise().reverse();
    A = turn * A * turn.transpose();
    B = turn * B;
    Eigen::VectorXd units(n);
    for (double& unit : units) unit = std::pow(10.0, 0.5 * decades * uniform_(generator_));
    A = units.asDiagonal() * A * units.cwiseInverse().asDiagonal();
    B = units.asDiagonal() * B;
    StateSpace made{A,           B,  Eigen::MatrixXd::Zero(1, n), Eigen::MatrixXd::Zero(1, inputs), {}, {},
                    {{"y", ""}}, 0.0};
    made.states.resize(static_cast<std::size_t>(n));
    made.inputs.resize(static_cast<std::size_t>(inputs));
    return made;
  }

 private:
  std::mt19937_64 generator_{7};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

StateSpace dual(const StateSpace& system) {
  StateSpace made = system;
  made.A = system.A.transpose();
  made.B = system.C.transpose();
  made.C = system.B.transpose();
  made.D = system.D.transpose();
  return made;
}

}  // namespace

TEST_CASE("ranks do not depend on the units of states") {
  RandomSystems random;
  for (const int decades : {0, 6, 12})
    for (int k = 0; k < 100; ++k) {
      const Eigen::Index n = random.from_one_to(12), reached = random.from_one_to(n),
                         inputs = random.from_one_to(3);
      const StateSpace system = random.system(n, reached, inputs, decades);
      INFO(n << " states, " << reached << " of them, " << inputs << " inputs, " << decades << " decades");
      CHECK(controllability(system).rank == reached);
      CHECK(observability(dual(system)).rank == reached);
    }
}

TEST_CASE("ranks are known or not certain where states of any structure have units 18 decades apart") {
  using Kind = RandomSystems::Kind;
  RandomSystems random;
  int uncertain = 0;
  for (const Kind kind : {Kind::full, Kind::chain, Kind::modes})
    for (int k = 0; k < 200; ++k) {
      const Eigen::Index n = random.from_one_to(12), reached = random.from_one_to(n),
                         inputs = random.from_one_to(3);
      const StateSpace system = random.system(n, reached, inputs, 18, kind, k % 2 == 0);
      INFO(n << " states, " << reached << " of them, " << inputs << " inputs, kind " << static_cast<int>(kind)
             << ", case " << k);
      const Rank control = controllability(system), observe = observability(dual(system));
      CHECK((control.rank == reached || !control.certain));
      CHECK((observe.rank == reached || !observe.certain));
      CHECK(control.singular_values.size() == static_cast<std::size_t>(n));
      uncertain += control.certain ? 0 : 1;
    }
  CHECK(uncertain <= 30);
}

TEST_CASE("a direction within rounding is not certain") {
  const auto with_coupling = [](double coupling) {
    StateSpace system{Eigen::Matrix2d{{-1.0, 0.0}, {0.0, -1.0 - coupling}},
                      Eigen::Vector2d::Ones(),
                      Eigen::RowVector2d::Ones(),
                      Eigen::MatrixXd::Zero(1, 1),
                      {},
                      {},
                      {{"y", ""}},
                      0.0};
    system.states.resize(2);
    system.inputs.resize(1);
    return controllability(system);
  };
  CHECK((with_coupling(1e-3).rank == 2 && with_coupling(1e-3).certain));
  CHECK((with_coupling(0.0).rank == 1 && with_coupling(0.0).certain));
  CHECK_FALSE(with_coupling(1e-12).certain);
}

TEST_CASE("sampled states that are multiples of others are not counted twice") {
  // x[k+1] of each lag follows the same input: two lags of one time constant are one.
  for (const double scale : {1.0, 1e-4, 1e5}) {
    const Eigen::Vector4d poles(0.9, 0.9, 0.5, 0.0);
    StateSpace system{poles.asDiagonal(),
                      Eigen::Vector4d(0.1, 0.1 * scale, 0.5, scale),
                      Eigen::RowVector4d::Ones(),
                      Eigen::MatrixXd::Zero(1, 1),
                      {},
                      {{"u", ""}},
                      {{"y", ""}},
                      0.01};
    system.states.resize(4);
    CHECK(controllability(system).rank == 3);
    CHECK(observability(system).rank == 3);
  }
}

TEST_CASE("a chain of integrators of far different rates is controllable as a whole") {
  for (const double rate : {1e-3, 1.0, 1e4}) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(8, 8);
    for (int i = 1; i < 8; ++i) A(i, i - 1) = i % 2 == 0 ? rate : 1.0 / rate;
    StateSpace system{A,
                      Eigen::MatrixXd::Identity(8, 1),
                      Eigen::MatrixXd::Zero(1, 8),
                      Eigen::MatrixXd::Zero(1, 1),
                      {},
                      {{"u", ""}},
                      {{"y", ""}},
                      0.0};
    system.states.resize(8);
    system.C(0, 7) = 1.0;
    CHECK(controllability(system).rank == 8);
    CHECK(observability(system).rank == 8);
  }
}

TEST_CASE("a loop with a thousand samples of delay has all of its ranks within seconds") {
  // x[k+1] = x[k] + u[k], and x passes through a line of 1000 samples: [B, A B, ...] is triangular.
  constexpr Eigen::Index n = 1001;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  A(0, 0) = 1.0;
  for (Eigen::Index i = 1; i < n; ++i) A(i, i - 1) = 1.0;
  StateSpace system{A,
                    Eigen::VectorXd::Unit(n, 0),
                    Eigen::RowVectorXd::Unit(n, n - 1),
                    Eigen::MatrixXd::Zero(1, 1),
                    {},
                    {{"u", ""}},
                    {{"y", ""}},
                    1e-3};
  system.states.resize(n);
  CHECK(controllability(system).rank == n);
  CHECK(observability(system).rank == n);
}

}  // namespace stepwire::linear
