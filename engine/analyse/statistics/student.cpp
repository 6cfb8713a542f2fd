#include "engine/analyse/statistics/student.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace stepwire::statistics {

double student_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), probability);
}

}  // namespace stepwire::statistics
