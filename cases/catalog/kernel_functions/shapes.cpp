// Shapes against B-splines by the recursion of Cox and de Boor, and their integrals, which are B-splines of the next degree.
#include <algorithm>
#include <cmath>
#include <string>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "cases/catalog/kernel_functions/splines.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline::kernel_functions::shapes_trial {
namespace {

std::string place_name(double x) { return std::to_string(x).substr(0, 5); }

// Sums over the nodes near a place of its weights times powers of the distance, and the affine weights.
template <class Weight>
double second_moment(int first, int support, double f, const Weight& weight) {
  double sum = 0;
  for (int k = 0; k < support; ++k) sum += weight(k) * (first + k - f) * (first + k - f);
  return sum;
}

// places: from the anchor node, in cells.
template <class Shape>
void add_spline(const std::string& name, std::initializer_list<double> places, KnownAnswers& all) {
  constexpr int degree = Shape::degree, support = Shape::support;
  all.push_back({name + ".support", 1.0 * support, degree + 1.0});
  all.push_back({name + ".blur", Shape::blur, (degree + 1) / 24.0});
  for (const double f : places) {
    double w[support], g[support], c[support], a[support];
    Shape::weights(f, w);
    Shape::gradients(f, g);
    Shape::above(f, c);
    Shape::affine_weights(f, a);
    const auto weight = [&](int k) { return spline(degree, f - (Shape::first + k)); };
    const double inertia = second_moment(Shape::first, support, f, weight);
    const std::string at = name + "." + place_name(f);
    all.push_back({at + ".inertia", Shape::inertia(f), inertia});
    for (int k = 0; k < support; ++k) {
      const double from = f - (Shape::first + k);  // from the node to the place
      const std::string node = at + ".node" + std::to_string(k);
      all.push_back({node + ".weight", w[k], weight(k)});
      all.push_back({node + ".gradient", g[k], spline_slope(degree, from)});
      all.push_back({node + ".above", c[k], 1 - spline_integral(degree, from)});
      all.push_back({node + ".affine", a[k], -weight(k) * from / inertia});
    }
  }
}

struct Anchored {
  double x;  // cells from the first node line
  int cells, node;
};

template <class Shape>
void add_anchors(const std::string& name, std::initializer_list<Anchored> places, KnownAnswers& all) {
  for (const Anchored& one : places) {
    double local = 0;
    const int node = Shape::anchor(one.x, one.cells, local);
    const std::string at = name + ".anchor." + place_name(one.x);
    all.push_back({at, 1.0 * node, 1.0 * one.node});
    all.push_back({at + ".local", local, one.x - one.node});
  }
}

// The integral of a tent over a box, divided by its width.
double over_box(double from, double half) {
  return (spline_integral(1, from + half) - spline_integral(1, from - half)) / (2 * half);
}

void add_boxes(KnownAnswers& all) {
  // A box within a cell, one that reaches over a node, and one as wide as a cell.
  for (const double half : {0.125, 0.25, 0.375, 0.5}) {
    for (const double f : {-0.4375, -0.1875, 0.0625, 0.28125, 0.49609375}) {
      double w[Gimp::support], g[Gimp::support], a[Gimp::support];
      Gimp::weights(f, half, w);
      Gimp::gradients(f, half, g);
      Gimp::affine_weights(f, half, a);
      const auto weight = [&](int k) { return over_box(f - (Gimp::first + k), half); };
      const double inertia = second_moment(Gimp::first, Gimp::support, f, weight);
      const std::string at = "box." + place_name(half) + "." + place_name(f);
      all.push_back({at + ".inertia", Gimp::inertia(f, half), inertia});
      all.push_back({at + ".inertia_at", Gimp::inertia_at(f + 3, half), inertia});
      for (int k = 0; k < Gimp::support; ++k) {
        const double from = f - (Gimp::first + k);
        const std::string node = at + ".node" + std::to_string(k);
        all.push_back({node + ".weight", w[k], weight(k)});
        all.push_back({node + ".gradient", g[k], (spline(1, from + half) - spline(1, from - half)) / (2 * half)});
        all.push_back({node + ".affine", a[k], -weight(k) * from / inertia});
      }
    }
  }
  double w[Gimp::support];
  Gimp::weights(0.28125, w);
  for (int k = 0; k < Gimp::support; ++k)
    all.push_back({"box.usual" + std::to_string(k), w[k], over_box(0.28125 - (Gimp::first + k), 0.25)});
  // Half the variance of a tent and of a box of a half size of a quarter cell.
  all.push_back({"box.blur", Gimp::blur, (1.0 / 6 + 1.0 / 48) / 2});
  // So narrow a box on a node is taken to have a quarter of the least half size as its inertia.
  double affine[Gimp::support];
  const double narrow = Gimp::narrowest / 8;
  Gimp::affine_weights(0.0, narrow, affine);
  all.push_back({"box.narrow", affine[2], narrow / 4 / (Gimp::narrowest / 4)});
}

}  // namespace

KnownAnswers shape_answers() {
  KnownAnswers all;
  add_spline<Linear>("linear", {0.0625, 0.3125, 0.8125}, all);
  add_spline<Quadratic>("quadratic", {-0.4375, -0.1875, 0.0625, 0.40625}, all);
  add_spline<Cubic>("cubic", {0.0625, 0.3125, 0.8125}, all);
  add_anchors<Linear>("linear", {{0, 4, 0}, {2.625, 4, 2}, {3, 4, 3}, {4, 4, 3}}, all);
  add_anchors<Quadratic>("quadratic", {{0, 4, 0}, {2.49609375, 4, 2}, {2.50390625, 4, 3}, {4, 4, 4}}, all);
  add_anchors<Cubic>("cubic", {{0, 4, 0}, {2.625, 4, 2}, {3, 4, 3}, {4, 4, 3}}, all);
  add_anchors<Gimp>("box", {{0, 4, 0}, {2.49609375, 4, 2}, {2.50390625, 4, 3}, {4, 4, 4}}, all);
  add_boxes(all);
  return all;
}

}  // namespace plumbline::kernel_functions::shapes_trial
