#include "kernel/geometry.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

template <class Vector>
Vector random_vector(scenes::Random& random) {
  Vector v;
  for (int k = 0; k < v.size(); ++k) v.data()[k] = random(-1, 1);
  return v;
}

// s . strain(v g^T) = v . force(s, g) for any stress, velocity and gradient: what the forces do is what the
// strains get. A dozen products of numbers below one: 4e-15 is about twenty roundings. [York 3.17, 3.23]
template <class Geometry>
void expect_adjoint() {
  scenes::Random random(3);
  for (int k = 0; k < 200; ++k) {
    const auto s = random_vector<typename Geometry::Strain>(random);
    const auto v = random_vector<typename Geometry::Vec>(random);
    const auto g = random_vector<typename Geometry::Vec>(random);
    const typename Geometry::Mat gradient = v * g.transpose();
    EXPECT_NEAR(s.dot(Geometry::strain(gradient)), v.dot(Geometry::force(s, g)), 4e-15);
  }
}

TEST(Geometry, ForceIsAdjointToStrainOnALine) { expect_adjoint<Line>(); }
TEST(Geometry, ForceIsAdjointToStrainInThePlane) { expect_adjoint<Plane>(); }

// [York 3.23] e = (L + L^T)/2; the shear stands as 2 e_xy.
TEST(Geometry, StrainInThePlane) {
  Plane::Mat gradient;
  gradient << 1, 2, 5, 7;
  EXPECT_EQ(Plane::strain(gradient), Plane::Strain(1, 7, 7));
  Plane::Mat rotation;
  rotation << 0, -3, 3, 0;
  EXPECT_EQ(Plane::strain(rotation), Plane::Strain(0, 0, 0));
}

// [York 3.17] sigma . grad N with sigma = (xx, yy, xy).
TEST(Geometry, ForceInThePlane) {
  EXPECT_EQ(Plane::force(Plane::Strain(2, 3, 5), Plane::Vec(7, 11)), Plane::Vec(2 * 7 + 5 * 11, 5 * 7 + 3 * 11));
}

TEST(Geometry, CrossProduct) {
  EXPECT_EQ(cross<2>(Plane::Vec(2, 3), Plane::Vec(5, 7)), 2 * 7 - 3 * 5);
  EXPECT_EQ(cross<1>(Line::Vec(2.0), Line::Vec(5.0)), 0);
}

}  // namespace
}  // namespace plumbline
