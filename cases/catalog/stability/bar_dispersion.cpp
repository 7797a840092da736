#include "cases/catalog/stability/bar_dispersion.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/amplification.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

using Complex = std::complex<double>;

struct Maps {
  std::string name, transfer;
  int order = 2;  // of xpic and fmpm
};
const std::vector<Maps>& maps() {
  static const std::vector<Maps> all{
      {"pic", "pic"}, {"flip", "flip"}, {"apic", "apic"}, {"xpic2", "xpic"}, {"fmpm2", "fmpm"}};
  return all;
}
const std::vector<std::string> shapes{"linear", "gimp", "quadratic", "cubic"},
    integrators{"usf", "usavg", "musl", "usl"};

// Waves of eight, four and two and a half cells, and a step far below every limit.
const std::vector<double> waves{0.25 * std::numbers::pi, 0.5 * std::numbers::pi, 0.8 * std::numbers::pi};
constexpr double small_step = 0.5, bar_end = 0.3;
constexpr int points_per_cell = 2;

// Of the wave that runs to one side, 0 where all of it only decays.
Complex running(const Eigen::MatrixXcd& matrix) {
  Complex found = 0;
  for (const Complex value : eigenvalues(matrix)) {
    if (value.imag() > found.imag()) found = value;
  }
  return found;
}

Eigen::MatrixXcd by_linear_algebra(const reference::MapScheme& scheme, double theta) {
  const reference::ComplexMatrix matrix = reference::amplification_matrix(
      scheme, reference::regular_points(points_per_cell, (bar_end - 0.5) / points_per_cell), theta, small_step);
  return Eigen::Map<const Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      matrix.entries.data(), matrix.size, matrix.size);
}

// How far the eigenvalue of one step is from the nearest of the other, the most. Those at 0 and 1 are left out: they belong to
// what nodes do not see, and where several meet each is known to a root of the rounding.
double departure(const Eigen::MatrixXcd& found, const Eigen::MatrixXcd& exact) {
  constexpr double about = 0.05;
  const Eigen::VectorXcd here = eigenvalues(found);
  double worst = 0;
  for (const Complex value : eigenvalues(exact)) {
    if (std::abs(value) < about || std::abs(value - 1.0) < about) continue;
    worst = larger(worst, (here.array() - value).abs().minCoeff());
  }
  return worst;
}

// Every shape and order of straining with one transfer. Measure:
//   departure  of the eigenvalues of waves from the reference's, the largest of all
// Profile: a row each.
Findings dispersion(const Maps& with) {
  const StabilityProblem& bar = find_stability_problem("bar");
  double worst = 0;
  std::vector<std::vector<double>> table(5);
  for (const std::string& shape : shapes) {
    for (const std::string& integrator : integrators) {
      const Settings settings = stability_settings(bar, "default",
                                                   {{"integrator", integrator},
                                                    {"transfer", with.transfer},
                                                    {"transfer_order", static_cast<double>(with.order)},
                                                    {"shape", shape},
                                                    {"ppc", static_cast<double>(points_per_cell)},
                                                    {"N", bar_end}});
      const Amplification found(bar.patch(settings, {1, 10}), {integrator, {}}, Positions::frozen, small_step);
      for (const double theta : waves) {
        const Eigen::MatrixXcd matrix = found.at({theta, 0}),
                               reference = by_linear_algebra(*map_scheme(settings), theta);
        worst = larger(worst, departure(matrix, reference));
        const Complex here = running(matrix), exact = running(reference);
        const double row[] = {static_cast<double>(table[0].size() + 1), theta, std::arg(here) / (theta * small_step),
                              std::arg(exact) / (theta * small_step), 1 - std::abs(here)};
        for (std::size_t k = 0; k < table.size(); ++k) table[k].push_back(row[k]);
      }
    }
  }
  Findings findings;
  findings.measures = {scalar_measure("departure", worst, 0, 1e-13, "1")};
  findings.profile.abscissa = "row";
  findings.profile.columns = {{"row", "1", "shape by shape, and order of straining", table[0]},
                              {"theta", "1", "phase of the wave from cell to cell", table[1]},
                              {"speed", "c", "speed of the wave", table[2]},
                              {"speed_reference", "c", "by linear algebra", table[3]},
                              {"decay", "1", "what a step takes of it", table[4]}};
  return findings;
}

}  // namespace

std::vector<Trial> dispersion_trials() {
  std::vector<Trial> all;
  for (const Maps& with : maps()) {
    all.push_back({"dispersion-" + with.name, with.name + ": speed and decay of waves of a few cells",
                   "Four shapes, four orders of straining, three waves.", [&with] { return dispersion(with); }});
  }
  return all;
}

std::vector<CaseGate> dispersion_gates() {
  const Because linear = theory(
      "a step that is linear has one matrix, by differences and by linear algebra; differences "
      "know it to 1e-9, and its eigenvalues, two of which come close where waves decay, to 1e-6");
  std::vector<CaseGate> all;
  for (const Maps& with : maps()) {
    all.push_back(gate("dispersion-" + with.name + "/eigenvalues", error_of("departure"), at_most(1e-6), linear));
  }
  return all;
}

}  // namespace plumbline
