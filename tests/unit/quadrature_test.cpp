#include "vesper/atmosphere/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vesper {
namespace {

TEST(Quadrature, RulesAreExactForTheirPolynomials) {
  for (int degree = 0; degree <= 22; ++degree) {
    double fine = 0.0;
    double coarse = 0.0;
    visit_kronrod_nodes(0.0, 2.0, [&](double x, double kronrod, double gauss) {
      fine += kronrod * std::pow(x, degree);
      coarse += gauss * std::pow(x, degree);
    });
    const double exact = std::pow(2.0, degree + 1) / (degree + 1);
    EXPECT_NEAR(fine / exact, 1.0, 1.0e-14) << degree;
    if (degree <= 13) {
      EXPECT_NEAR(coarse / exact, 1.0, 1.0e-14) << degree;
    }
  }
}

TEST(Quadrature, NodesAscendFromBeginToEnd) {
  double last = -3.0;
  int count = 0;
  visit_kronrod_nodes(-3.0, 5.0, [&](double x, double, double) {
    EXPECT_GT(x, last);
    last = x;
    ++count;
  });
  EXPECT_LT(last, 5.0);
  EXPECT_EQ(count, 15);
}

TEST(Quadrature, BoundHoldsForKinksAndSteepSlopes) {
  const auto kink = [](double x) { return std::abs(x - 0.3); };
  const auto steep = [](double x) { return std::exp(-200.0 * x); };
  const Integral of_kink = integrate(kink, 0.0, 1.0);
  const Integral of_steep = integrate(steep, 0.0, 1.0);
  EXPECT_LE(std::abs(of_kink.value - (0.5 * 0.09 + 0.5 * 0.49)), of_kink.error + 1.0e-15);
  EXPECT_LE(std::abs(of_steep.value - 0.005), of_steep.error + 1.0e-15);
  EXPECT_LT(of_kink.error, 1.0e-8);
  EXPECT_LT(of_steep.error, 1.0e-10);
}

TEST(Quadrature, NothingOverNothing) {
  EXPECT_EQ(integrate([](double) { return 1.0; }, 2.0, 2.0).value, 0.0);
}

} // namespace
} // namespace vesper
