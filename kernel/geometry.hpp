// A geometry is an adjoint pair: `strain` turns a velocity gradient into strain rates, `flux` turns stresses into what a
// point puts on a node with shape N and shape gradient g. For every stress s, nodal velocity v, and radius r
//   s . strain(v g^T, v_r N / r) = sum_cd v_c flux(s)_cd g_d + hoop(s) v_r N / r.
// Components: normal strains, then engineering shears (twice the tensor's), so that a plain dot product is a power.
// Number: double, or a pack of them.
#pragma once

namespace plumbline {

// 1-D: xx.
struct Line {
  static constexpr int dim = 1, normals = 1, strains = 1, rotations = 0;
  static constexpr bool axisymmetric = false;
  template <class Number>
  static void strain(const Number (&l)[1][1], const Number&, Number (&e)[1]) {
    e[0] = l[0][0];
  }
  template <class Number>
  static void flux(const Number (&s)[1], Number (&f)[1][1]) {
    f[0][0] = s[0];
  }
};

// Plane 2-D, no strain out of the plane: xx, yy, 2 xy. [York 3.23]
struct Plane {
  static constexpr int dim = 2, normals = 2, strains = 3, rotations = 1;
  static constexpr bool axisymmetric = false;
  template <class Number>
  static void strain(const Number (&l)[2][2], const Number&, Number (&e)[3]) {
    e[0] = l[0][0];
    e[1] = l[1][1];
    e[2] = l[0][1] + l[1][0];
  }
  template <class Number>
  static void flux(const Number (&s)[3], Number (&f)[2][2]) {
    f[0][0] = s[0];
    f[1][1] = s[1];
    f[0][1] = f[1][0] = s[2];
  }
};

// Axisymmetric without swirl, x the radius, y the axis: rr, zz, hoop, 2 rz. Masses and volumes are per radian.
// (Sulsky, Schreyer 1996, doi 10.1016/S0045-7825(96)01091-2)
struct Axisymmetric {
  static constexpr int dim = 2, normals = 3, strains = 4, rotations = 0;
  static constexpr bool axisymmetric = true;
  static constexpr int hoop = 2;  // component of the hoop strain v_r / r
  template <class Number>
  static void strain(const Number (&l)[2][2], const Number& hoop_rate, Number (&e)[4]) {
    e[0] = l[0][0];
    e[1] = l[1][1];
    e[2] = hoop_rate;
    e[3] = l[0][1] + l[1][0];
  }
  template <class Number>
  static void flux(const Number (&s)[4], Number (&f)[2][2]) {
    f[0][0] = s[0];
    f[1][1] = s[1];
    f[0][1] = f[1][0] = s[3];
  }
};

// 3-D: xx, yy, zz, 2 yz, 2 zx, 2 xy.
struct Solid {
  static constexpr int dim = 3, normals = 3, strains = 6, rotations = 3;
  static constexpr bool axisymmetric = false;
  template <class Number>
  static void strain(const Number (&l)[3][3], const Number&, Number (&e)[6]) {
    for (int d = 0; d < 3; ++d) e[d] = l[d][d];
    e[3] = l[1][2] + l[2][1];
    e[4] = l[2][0] + l[0][2];
    e[5] = l[0][1] + l[1][0];
  }
  template <class Number>
  static void flux(const Number (&s)[6], Number (&f)[3][3]) {
    for (int d = 0; d < 3; ++d) f[d][d] = s[d];
    f[1][2] = f[2][1] = s[3];
    f[2][0] = f[0][2] = s[4];
    f[0][1] = f[1][0] = s[5];
  }
};

// Strain components of a geometry: 1, 3, 4 (axisymmetric) or 6; the normal ones come first.
inline constexpr int strain_components(int dim, bool axisymmetric) {
  return dim == 1 ? 1 : dim == 3 ? 6 : axisymmetric ? 4 : 3;
}
inline constexpr int normal_components(int dim, bool axisymmetric) { return dim == 2 && axisymmetric ? 3 : dim; }

}  // namespace plumbline
