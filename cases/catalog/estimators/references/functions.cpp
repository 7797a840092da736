// Functions, roots, integrals and spectra that references are made of, where their values are known.
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/catalog/estimators/answers.hpp"
#include "reference/bessel.hpp"
#include "reference/elliptic.hpp"
#include "reference/interlacing.hpp"
#include "reference/quadrature.hpp"
#include "reference/root.hpp"
#include "reference/spectral_radius.hpp"

namespace plumbline {
namespace {

using reference::Bounded;

void add_bounded(const std::string& name, Bounded found, double value, double bound, KnownAnswers& all) {
  all.push_back({name + ".value", found.value, value, std::max(1.0, std::abs(value))});
  all.push_back({name + ".bound", found.bound, bound, std::max(1.0, bound)});
}

// Tables of Abramowitz and Stegun, 9.1, 9.5 and 17.1; Gauss's constant. A bound of 0 stands for roundings.
void add_special(KnownAnswers& all) {
  add_bounded("J0", reference::bessel_J0(Bounded(-1, 0.1)), 0.76519768655796655, 0.05819, all);
  add_bounded("J1", reference::bessel_J1(Bounded(1, 0.1)), 0.44005058574493352, 0.05, all);
  add_bounded("J1_odd", reference::bessel_J1(Bounded(-1)), -0.44005058574493352, 0, all);
  add_bounded("J2", reference::bessel_J(2, Bounded(3, 0.1)), 0.48609126058589108, 0.07072, all);
  add_bounded("J0_zero", reference::bessel_zero_J0(5), 14.930917708487786, 0, all);
  add_bounded("J1_zero", reference::bessel_zero_J(1, 1), 3.8317059702075123, 0, all);
  add_bounded("J5_zero", reference::bessel_zero_J(5, 2), 12.338604197466944, 0, all);
  add_bounded("K", reference::elliptic_K(std::sqrt(0.5), std::sqrt(0.5)), 1.8540746773013719, 0, all);
  add_bounded("K_of_zero", reference::elliptic_K(0, 1), std::numbers::pi / 2, 0, all);
  add_bounded("mean", reference::gauss_mean(1, std::numbers::sqrt2), 1.1981402347355923, 0, all);
}

void add_integrals(KnownAnswers& all) {
  const auto cube = [](double x) { return Bounded(x) * x * x; };
  add_bounded("cube", reference::integrate(cube, 0, 2), 4, 0, all);
  add_bounded("cosine", reference::integrate([](double x) { return cos(Bounded(x)); }, 0, std::numbers::pi / 2), 1, 0,
              all);
  // Halved towards its end until what is left is rounding.
  add_bounded("root", reference::integrate([](double x) { return sqrt(Bounded(x)); }, 0, 1), 2.0 / 3, 0, all);
  // Bounds of the function's own values add up.
  add_bounded("unsure", reference::integrate([](double x) { return Bounded(x, 0.01); }, 1, 3), 4, 0.02, all);
}

void add_roots(KnownAnswers& all) {
  all.push_back({"brent", reference::brent_root([](double x) { return x * x - 2; }, 0, 3), std::numbers::sqrt2});
  const auto three = [](double x) { return Bounded(x - 3, 0.1); };
  const auto enclosed = [&](double slope, double least, double greatest) {
    return reference::enclose_root(three, 3.05, slope, least, greatest);
  };
  // |f| and its bound over the slope, an eighth more; a wrong slope is made good by quarters.
  add_bounded("enclosed", enclosed(1, -10, 10), 3.05, 0.15 * 1.125, all);
  add_bounded("enclosed_later", enclosed(2, -10, 10), 3.05, 0.075 * 1.125 * std::pow(1.25, 3), all);
  add_bounded("within_ends", enclosed(2, 3, 3.1), 3.05, 0.075 * 1.125, all);

  const auto slope = [](double) { return 1.0; };
  const auto at = [](double root) { return [root](double x) { return Bounded(x) - root; }; };
  add_bounded("between", reference::root_between(at(2.5), slope, 2, 3), 2.5, 0, all);
  add_bounded("below", reference::root_between(at(1), slope, 2, 3), 2, 1.125, all);
  add_bounded("above", reference::root_between(at(4), slope, 2, 3), 3, 1.125, all);
  add_bounded("merged_poles", reference::root_between(at(2.5), slope, {2, 0.6}, {3, 0.6}), 2.5, 1.1, all);

  // Of 1.9 to 2.1 and 3: the n-th smallest of the one and of the other ends.
  const std::vector<Bounded> both = reference::merged_multiples({2, 0.1}, 3, 6);
  const double values[] = {2, 3, 4, 5.85, 6.15, 8}, bounds[] = {0.1, 0, 0.2, 0.15, 0.15, 0.4};
  all.push_back({"multiples", static_cast<double>(both.size()), 6});
  for (std::size_t n = 0; n < both.size(); ++n) {
    add_bounded("multiple" + std::to_string(n), both[n], values[n], bounds[n], all);
  }
  const std::vector<Bounded> one = reference::merged_multiples(2, std::numeric_limits<double>::infinity(), 3);
  for (std::size_t n = 0; n < one.size(); ++n) add_bounded("of_one", one[n], 2.0 * static_cast<double>(n + 1), 0, all);
}

reference::SquareMatrix matrix_of(int size, const std::vector<double>& entries) {
  reference::SquareMatrix matrix(size);
  matrix.entries = entries;
  return matrix;
}

void add_spectra(KnownAnswers& all) {
  const reference::SquareMatrix diagonal = matrix_of(3, {1, 0, 0, 0, -3, 0, 0, 0, 2}),
                                turn = matrix_of(2, {1.2, -1.6, 1.6, 1.2}), jordan = matrix_of(2, {1, 1, 0, 1});
  add_bounded("diagonal", reference::spectral_radius(diagonal), 3, 0, all);
  add_bounded("turn", reference::spectral_radius(turn), 2, 0, all);
  // Eigenvectors of length one: (2 n - 1) n e |A| by Bauer and Fike.
  constexpr double error = 1e-3;
  add_bounded("unsure_diagonal", reference::spectral_radius(diagonal, error), 3, 5 * 3 * error * std::sqrt(14.0), all);
  // Without a second eigenvector Elsner's bound is left.
  const double norm = std::sqrt(3.0), shift = error * norm;
  add_bounded("jordan", reference::spectral_radius(jordan, error), 1, std::sqrt((2 * norm + shift) * shift), all);
  reference::ComplexMatrix complex(2);
  complex(0, 0) = {0.6, 0.8};
  complex(0, 1) = {5, -2};
  complex(1, 1) = {0, -1.5};
  all.push_back({"complex.value", reference::spectral_radius(complex).value, 1.5});
}

}  // namespace

KnownAnswers function_answers() {
  KnownAnswers all;
  add_special(all);
  add_integrals(all);
  add_roots(all);
  add_spectra(all);
  return all;
}

}  // namespace plumbline
