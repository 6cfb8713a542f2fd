// Parameters that are matrices. Reference numbers of designs: octave 7.3 with control 3.4,
//   A=[0 1 0 0;0 -0.1 3 0;0 0 0 1;0 -0.5 30 0]; B=[0;2;0;5]; C=[1 0 0 0;0 0 1 0]; Q=diag([1 0 1 0]);
//   lqr(A,B,Q,1), s=c2d(ss(A,B,C,0),0.01), dlqr(s.a,s.b,Q,0.5), lqe(A,eye(4),C,eye(4),0.1*eye(2)),
//   dlqe(s.a,eye(4),C,0.01*eye(4),0.1*eye(2)), place(A,B,[-1 -2 -3 -4]), place(A,B,[-1+i -1-i -3 -4]),
//   expm([1 2;3 4])
// and scipy 1.10: linalg.solve_continuous_are(A,B2,Q,diag([1,2])), B2=[0 0;2 .3;0 0;5 1].
#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string plant =
    "parameters:\n"
    "  A: [[0, 1, 0, 0], [0, -0.1, 3, 0], [0, 0, 0, 1], [0, -0.5, 30, 0]]\n"
    "  B: [0, 2, 0, 5]\n"
    "  B2: [[0, 0], [2, 0.3], [0, 0], [5, 1]]\n"
    "  C: [[1, 0, 0, 0], [0, 0, 1, 0]]\n"
    "  Q: = diag(1, 0, 1, 0)\n"
    "  Ad: = c2d(A, 0.01)\n"
    "  Bd: = c2d(A, B, 0.01)\n"
    "  found: = ";
// Every parameter is used, so that none is refused.
const std::string use =
    "\nblocks: {c: {block: MatrixGain, u: [1, 1, 1, 1], gain: = C*A*diag(B)*eye(4)}, d: {block: MatrixGain,"
    " u: [1, 1, 1, 1], gain: = Q + Ad + diag(Bd) + B2*transpose(B2)}, e: {block: Constant, value: = "
    "norm(found)}}\n"
    "record: [c]\n";

Eigen::MatrixXd found(const std::string& formula, const std::string& head = plant,
                      const std::string& tail = use) {
  const plan::Plan plan = plan_text(head + formula + tail);
  for (const DiagramParameter& parameter : plan.diagram.parameters)
    if (parameter.name == "found") {
      if (const double* number = std::get_if<double>(&parameter.value.content))
        return Eigen::MatrixXd::Constant(1, 1, *number);
      if (const auto* vector = std::get_if<Eigen::VectorXd>(&parameter.value.content)) return *vector;
      return std::get<Eigen::MatrixXd>(parameter.value.content);
    }
  throw std::runtime_error("nothing is found");
}

/// The largest relative error of a row.
double error_of_row(const Eigen::MatrixXd& row, std::initializer_list<double> expected) {
  REQUIRE(row.size() == static_cast<Eigen::Index>(expected.size()));
  const Eigen::Map<const Eigen::VectorXd> wanted(expected.begin(), row.size());
  return (row.reshaped() - wanted).cwiseAbs().maxCoeff() / wanted.cwiseAbs().maxCoeff();
}

std::string fault(const std::string& formula) {
  const auto faults = faults_of(plant + formula + use);
  return faults.empty() ? "" : faults[0];
}

}  // namespace

TEST_CASE("the regulator has the gain of octave's lqr") {
  CHECK(error_of_row(found("lqr(A, B, Q, 1)"), {-9.999999999999973e-01, -1.755859261852397e+00,
                                                1.691449006571621e+01, 3.227358768653223e+00}) < 1e-13);
}

TEST_CASE("the regulator of two inputs has the gain that follows from scipy's solution") {
  const Eigen::MatrixXd K = found("lqr(A, B2, Q, diag(1, 2))");
  CHECK(error_of_row(K.row(1),
                     {-0.157796143407851, -0.247406497833334, 1.87783670314215, 0.362917875998437}) < 1e-12);
}

TEST_CASE("a sampled system has the matrices of octave's c2d") {
  CHECK(error_of_row(found("c2d(A, B, 0.01)"), {9.997292187409611e-05, 1.999250183293310e-02,
                                                2.498958499966152e-04, 4.997500479026812e-02}) < 1e-14);
  CHECK(found("c2d(A, 0.01)")(3, 2) == Approx(0.300075009999107).epsilon(1e-14));
}

TEST_CASE("the sampled regulator has the gain of octave's dlqr") {
  CHECK(error_of_row(found("dlqr(Ad, Bd, Q, 0.5)"), {-1.325335292413435e+00, -2.028634109002644e+00,
                                                     1.736045427923040e+01, 3.326063309793323e+00}) < 1e-12);
}

TEST_CASE("the estimators have the gains of octave's lqe and dlqe") {
  const Eigen::MatrixXd L = found("kalman(A, C, eye(4), 0.1*eye(2))");
  CHECK(error_of_row(L.col(0),
                     {4.020027391803598, 3.226289953492756, 0.5403329308253357, 2.921486405919691}) < 1e-13);
  const Eigen::MatrixXd M = found("dkalman(Ad, C, 0.01*eye(4), 0.1*eye(2))");
  CHECK(error_of_row(M.col(1), {-7.171032076782203e-04, -1.445687562730660e-02, 2.868033212663864e-01,
                                6.390513616237974e-01}) < 1e-12);
}

TEST_CASE("poles of one input are placed by octave's gain, real and in pairs") {
  CHECK(error_of_row(found("place(A, B, [-1, -2, -3, -4])"), {-5.333333333333341e-01, -1.294034385652884,
                                                              13.46309470875945, 2.497613754261154}) < 1e-12);
  CHECK(error_of_row(found("place(A, B, [[-1, 1], [-1, -1], [-3, 0], [-4, 0]])"),
                     {-5.333333333333331e-01, -1.011464354527938, 12.03179190751445, 2.184585741811175}) <
        1e-12);
}

TEST_CASE("poles of two inputs are where they are wanted, with gains not much above scipy's") {
  const Eigen::MatrixXd K = found("place(A, B2, [[-1, 1], [-1, -1], [-3, 0], [-4, 0]])");
  Eigen::Matrix4d A;
  A << 0, 1, 0, 0, 0, -0.1, 3, 0, 0, 0, 0, 1, 0, -0.5, 30, 0;
  Eigen::Matrix<double, 4, 2> B;
  B << 0, 0, 2, 0.3, 0, 0, 5, 1;
  const Eigen::Vector4cd poles = Eigen::Matrix4d(A - B * K).eigenvalues();
  std::complex<double> product = 1.0, sum = 0.0;
  for (const std::complex<double>& pole : poles) product *= pole, sum += pole;
  CHECK(product.real() == Approx(24.0).epsilon(1e-9));  // (-1 + i)(-1 - i)(-3)(-4)
  CHECK(sum.real() == Approx(-9.0).epsilon(1e-9));
  CHECK(K.norm() < 3.0 * 98.0);  // the norm of scipy's gain
}

TEST_CASE("formulas of matrices: products, powers, lists of lists, elements") {
  CHECK(error_of_row(found("expm([[1, 2], [3, 4]])"),
                     {51.96895619870499, 112.1048468505049, 74.73656456700324, 164.0738030492099}) < 1e-14);
  CHECK(found("[[1, 1], [0, 1]]^3")(0, 1) == 3.0);
  CHECK(found("det(inv([[1, 2], [3, 4]]))")(0, 0) == Approx(-0.5));
  CHECK(found("A.4.3 + B.2")(0, 0) == 32.0);
  CHECK(found("[[A, B], [transpose(B), [7]]]").rows() == 5);
  CHECK(found("trace(A)")(0, 0) == Approx(-0.1));
}

TEST_CASE("a matrix has formulas in it, in whatever order parameters stand") {
  const Eigen::MatrixXd matrix =
      found("[[a, 0], [2*a, 1]]", "parameters:\n  found: ",
            "\n  a: 3\nblocks: {c: {block: MatrixGain, u: [1, 1], gain: $found}}\nrecord: [c]\n");
  CHECK(matrix(0, 0) == 3.0);
  CHECK(matrix(1, 0) == 6.0);
}

TEST_CASE("sizes that do not fit, singular matrices and modes out of reach are refused with their place") {
  CHECK_THAT(fault("A*C"), Catch::Contains("4 x 4 and 2 x 4"));
  CHECK_THAT(fault("inv([[1, 2], [2, 4]])"), Catch::Contains("singular"));
  CHECK_THAT(fault("lqr([[1, 0], [0, 2]], [1, 0], eye(2), 1)"),
             Catch::Contains("not stabilizable") && Catch::Contains("eigenvalue 2"));
  CHECK_THAT(fault("lqr([[0, 1], [0, 0]], [0, 1], zeros(2), 1)"), Catch::Contains("in no weight"));
  CHECK_THAT(fault("place([[1, 0], [0, 2]], [1, 0], [-1, -2])"), Catch::Contains("not controllable"));
  CHECK_THAT(fault("lqr(A, B, Q, 0)"), Catch::Contains("R") && Catch::Contains("above 0"));
  CHECK_THAT(fault("eye(2.5)"), Catch::Contains("whole number"));
}

TEST_CASE("what follows from a matrix follows a setting") {
  const std::string text =
      "parameters:\n  m: 2\n  K: = lqr([[0, 1], [0, 0]], [0, 1/m], eye(2), 1)\n"
      "blocks: {c: {block: MatrixGain, u: [1, 1], gain: $K}}\nrecord: [c]\n";
  // Of a double integrator with the weights 1 the gains are 1 and sqrt(1 + 2 m)... by hand: k2^2 = 1 + 2 m
  // k1.
  for (const double m : {2.0, 3.0}) {
    const plan::Plan plan = plan_text(text, {{"m", std::to_string(m)}});
    const auto& K = std::get<Eigen::MatrixXd>(plan.diagram.parameters[1].value.content);
    CHECK(K(0, 0) == Approx(1.0));
    CHECK(K(0, 1) == Approx(std::sqrt(1.0 + 2.0 * m)));
  }
}

}  // namespace stepwire::diagram
