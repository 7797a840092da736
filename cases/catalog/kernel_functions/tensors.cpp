// Tensors and logarithms of packs of points, places by cubes, largest values, sums over lanes and rotations.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cases/catalog/kernel_functions/answers.hpp"
#include "kernel/largest.hpp"
#include "kernel/logarithm.hpp"
#include "kernel/points/cubes.hpp"
#include "kernel/points/pack_tensors.hpp"
#include "kernel/rotations.hpp"

namespace plumbline::kernel_functions::tensors_trial {
namespace {

using Tensor = Eigen::Matrix3d;

// No two components and no two points have the same.
double component(int k, int p, int which) { return std::sin(1.7 * k + 0.6 * p + 2.3 * which + 0.4) + 0.15 * k; }

// A tensor of a geometry in three directions: one on the diagonal where it has none.
template <int dim, bool rings>
Tensor tensor_of(int p, int which) {
  Tensor all = Tensor::Identity();
  for (int k = 0; k < dim * dim; ++k) all(k / dim, k % dim) = component(k, p, which);
  if (rings) all(2, 2) = component(4, p, which);
  return all;
}

template <int dim, bool rings>
void add_tensors(const std::string& name, KnownAnswers& all) {
  using Packed = PackTensor<dim, rings>;
  constexpr int points = 11;  // no whole number of packs
  Columns columns(points);
  columns.add(column::deformation, Packed::size);
  columns.add(column::stress, Packed::size);
  columns.add(column::strain_rate, Packed::size);
  for (int p = 0; p < points; ++p) {
    for (int k = 0; k < Packed::size; ++k) {
      columns(column::deformation, k)[p] = component(k, p, 0);
      columns(column::stress, k)[p] = component(k, p, 1);
    }
  }
  const Columns& read = columns;
  const TensorColumn<Packed, const double> first(read, column::deformation), second(read, column::stress);
  const TensorColumn<Packed, double> written(columns, column::strain_rate);
  const auto compare = [&](const std::string& what, int p, int lane, const Packed& found, const Tensor& exact) {
    for (int k = 0; k < Packed::size; ++k) {
      const double value = k == dim * dim ? exact(2, 2) : exact(k / dim, k % dim);
      all.push_back({name + what + std::to_string(k) + "." + std::to_string(p + lane),
                     found.at[k][static_cast<std::size_t>(lane)], value, std::max(1.0, std::abs(value))});
    }
  };
  for_packs(0, points, [&](int p, int count) {
    const Packed a = first[p], b = second[p], product = a * b, turned = a.transposed(), cofactors = a.cofactors();
    const Pack determinant = a.determinant(), squares = a.sum_of_squares();
    written.set(p, product, count);
    for (int lane = 0; lane < count; ++lane) {
      const Tensor one = tensor_of<dim, rings>(p + lane, 0), two = tensor_of<dim, rings>(p + lane, 1);
      compare(".product", p, lane, product, one * two);
      compare(".transposed", p, lane, turned, one.transpose());
      compare(".cofactor", p, lane, cofactors, one.determinant() * one.inverse().transpose());
      const std::string at = "." + std::to_string(p + lane);
      const auto own = static_cast<std::size_t>(lane);
      all.push_back({name + ".determinant" + at, determinant[own], one.determinant()});
      const double of_others = 3 - dim - (rings ? 1 : 0);
      all.push_back({name + ".squares" + at, squares[own], one.squaredNorm() - of_others, one.squaredNorm()});
    }
  });
  for (int p = 0; p < points; ++p) {
    const Tensor exact = tensor_of<dim, rings>(p, 0) * tensor_of<dim, rings>(p, 1);
    for (int k = 0; k < Packed::size; ++k) {
      all.push_back({name + ".written" + std::to_string(k) + "." + std::to_string(p),
                     columns(column::strain_rate, k)[p], k == dim * dim ? exact(2, 2) : exact(k / dim, k % dim)});
    }
  }
}

// All places whose cubes are those of x and beside it, and no others: by their numbers, and their squares.
void add_cubes(KnownAnswers& all) {
  constexpr double size = 0.4;
  std::vector<Eigen::Vector3d> places;
  for (int k = 0; k < 300; ++k)
    places.emplace_back(1.1 * std::sin(12.9 * k), 1.3 * std::sin(7.3 * k + 1), 1.2 * std::cos(4.1 * k * k));
  const Cubes cubes(places, size);
  const auto index = [&](const Eigen::Vector3d& x, int d) { return std::floor(x[d] / size); };
  for (int p = 0; p < 40; ++p) {
    const Eigen::Vector3d& x = cubes.place(static_cast<std::size_t>(p));
    double count = 0, sum = 0, squares = 0, exact_count = 0, exact_sum = 0, exact_squares = 0;
    cubes.for_near(x, [&](std::size_t k) {
      const auto number = static_cast<double>(k);
      ++count;
      sum += number;
      squares += number * number;
    });
    for (std::size_t k = 0; k < places.size(); ++k) {
      bool beside = true;
      for (int d = 0; d < 3; ++d)
        beside = beside && std::abs(index(places[k], d) - index(places[static_cast<std::size_t>(p)], d)) <= 1;
      if (!beside) continue;
      const auto number = static_cast<double>(k);
      ++exact_count;
      exact_sum += number;
      exact_squares += number * number;
    }
    const std::string at = "cubes." + std::to_string(p);
    all.push_back({at + ".count", count, exact_count});
    all.push_back({at + ".sum", sum, exact_sum});
    all.push_back({at + ".squares", squares, exact_squares});
  }
}

// Values of which the largest stands in each place in turn; what is beyond `count` is larger than all.
void add_largest(KnownAnswers& all) {
  constexpr int points = 11, most = 11 + 16;
  for (int top = 0; top < points; ++top) {
    for (const bool broken : {false, true}) {
      std::vector<double> values(most, 99.0);
      for (int p = 0; p < points; ++p) values[static_cast<std::size_t>(p)] = 0.5 + 0.03 * p;
      values[static_cast<std::size_t>(top)] = 2.5;
      if (broken) values[static_cast<std::size_t>(top)] = std::numeric_limits<double>::quiet_NaN();
      Largest largest;
      for_packs(0, points, [&](int p, int count) { largest.include(load(values.data() + p), count); });
      const std::string at = "largest." + std::to_string(top);
      if (broken) {
        all.push_back(yes(at + ".nan", std::isnan(largest.value())));
      } else {
        all.push_back({at, largest.value(), 2.5});
      }
    }
  }
  all.push_back({"largest.none", Largest().value(), 0});
}

template <int count>
void add_lanes(const std::string& name, KnownAnswers& all) {
  Pack packs[count];
  double values[count], exact[count];
  for (int k = 0; k < count; ++k) {
    packs[k] = Pack([&](std::size_t lane) { return component(k, static_cast<int>(lane), 2); });
    values[k] = exact[k] = 0.3 * k - 1;
    for (int lane = 0; lane < lanes; ++lane) exact[k] += component(k, lane, 2);
    all.push_back({name + ".sum" + std::to_string(k), sum(packs[k]), exact[k] - values[k], 1 + std::abs(exact[k])});
  }
  add_lane_sums<count>(packs, values);
  for (int k = 0; k < count; ++k)
    all.push_back({name + ".added" + std::to_string(k), values[k], exact[k], 1 + std::abs(exact[k])});
}

void add_rotations(KnownAnswers& all) {
  const Eigen::Vector2d a(1.3, -0.7), b(0.4, 2.1);
  all.push_back({"cross.plane", cross<2>(a, b)[0], 1.3 * 2.1 + 0.7 * 0.4});
  const Eigen::Vector3d c(1.3, -0.7, 0.9), d(0.4, 2.1, -1.6);
  const Spin<3> found = cross<3>(c, d);
  const double exact[] = {0.7 * 1.6 - 0.9 * 2.1, 0.9 * 0.4 + 1.3 * 1.6, 1.3 * 2.1 + 0.7 * 0.4};
  for (int k = 0; k < 3; ++k) all.push_back({"cross.space" + std::to_string(k), found[k], exact[k], 2});
  all.push_back({"rotations.line", 1.0 * rotation_count<1>, 0});
  all.push_back({"rotations.plane", 1.0 * rotation_count<2>, 1});
  all.push_back({"rotations.space", 1.0 * rotation_count<3>, 3});
}

}  // namespace

KnownAnswers tensor_answers() {
  KnownAnswers all;
  add_tensors<1, false>("line", all);
  add_tensors<2, false>("plane", all);
  add_tensors<2, true>("rings", all);
  add_tensors<3, false>("space", all);
  add_cubes(all);
  add_largest(all);
  add_lanes<1>("lanes1", all);
  add_lanes<4>("lanes4", all);
  add_lanes<7>("lanes7", all);
  add_lanes<9>("lanes9", all);
  add_rotations(all);
  return all;
}

// In units in the last place of the answer, which is that of a longer type.
KnownAnswers logarithm_answers() {
  KnownAnswers all;
  std::vector<double> values;
  for (int k = 0; k < 120; ++k) values.push_back(std::ldexp(0.7071 + 0.0061 * k, (k % 7) * (k % 11) - 20));
  for (int k = 0; k < 40; ++k) values.push_back(1 + std::ldexp(k % 2 == 0 ? 1.3 : -1.7, -k));
  for (int k = 0; k < 40; ++k) values.push_back(0.72 + 0.0171 * k);
  for (const double end : {std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), 1e-310, 3e-320})
    values.push_back(end);
  for (std::size_t first = 0; first < values.size(); first += lanes) {
    const auto at = [&](std::size_t lane) { return values[std::min(first + lane, values.size() - 1)]; };
    const Pack found = logarithm(Pack(at));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto exact = static_cast<double>(std::log(static_cast<long double>(at(lane))));
      const double unit = std::max(std::nextafter(std::abs(exact), HUGE_VAL) - std::abs(exact),
                                   std::numeric_limits<double>::min());
      all.push_back({"log." + std::to_string(at(lane)), found[lane], exact, unit});
    }
  }
  // One lane that the polynomial does not cover; the others beside it are as exact.
  const double none[] = {0, -2, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t odd = 0; odd < lanes; ++odd) {
    for (const double value : none) {
      const Pack found = logarithm(Pack([&](std::size_t lane) { return lane == odd ? value : 3.7; }));
      const std::string at = "odd" + std::to_string(odd) + "." + std::to_string(value);
      const double own = found[odd];
      all.push_back(yes(at, value == 0 ? own == -HUGE_VAL : value > 0 ? own == HUGE_VAL : std::isnan(own)));
      all.push_back({at + ".beside", found[(odd + 1) % lanes], std::log(3.7), 0x1p-52});
    }
  }
  return all;
}

}  // namespace plumbline::kernel_functions::tensors_trial
