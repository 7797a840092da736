#include "kernel/normals/normals.hpp"

#include <stdexcept>

#include "kernel/normals/circle_fit.hpp"
#include "kernel/normals/colour_gradient.hpp"
#include "kernel/normals/connectivity.hpp"
#include "kernel/normals/mass_matrix.hpp"

namespace plumbline {
namespace {

struct Connectivity final : NormalsMethod {
  void find(const NormalsInput& input, std::span<double> normal_x, std::span<double> normal_y) override {
    const int n = static_cast<int>(input.x.size());
    tangent_x_.resize(input.x.size());
    tangent_y_.resize(input.x.size());
    chain_tangents(input.x.data(), input.y.data(), n, 0, n, input.closed, tangent_x_.data(), tangent_y_.data());
    for (std::size_t p = 0; p < input.x.size(); ++p) {
      if (n < 2) {
        normal_x[p] = input.previous_x.empty() ? 0 : input.previous_x[p];
        normal_y[p] = input.previous_y.empty() ? 0 : input.previous_y[p];
      } else {
        normal_x[p] = -tangent_y_[p];
        normal_y[p] = tangent_x_[p];
      }
    }
  }

 private:
  std::vector<double> tangent_x_, tangent_y_;
};

}  // namespace

const std::vector<Choice>& normals_methods() {
  static const std::vector<Choice> all{
      {"connectivity", "mean of the angles of the two adjoining segments", "York 1997, (7.1)"},
      {"york-simple", "gradient of the points' colour by linear shapes", "York 1997, (7.2, 7.3)"},
      {"york-quadratic", "gradient of a colour smoothed to cell centres", "York 1997, (7.4, 7.5)"},
      {"york-cubic", "gradient of a colour smoothed by cubic splines", "York 1997, (7.6, 7.7)"},
      {"york-mass-matrix", "colours of a cell's nodes that are constant on its points", "York 1997, (7.8-7.12)"},
      {"york-mass-matrix-kept", "the same; a point alone in its cell keeps the normal it had",
       "York 1997, section 7.8"},
      {"york-mass-matrix-quadratic", "the mass matrix with nine colours and quadratic shapes",
       "York 1997, (7.18, 7.19)"},
      {"modern", "circles fitted to the points nearby, whatever their order",
       "Pratt 1987, doi 10.1145/37401.37420; Guennebaud, Gross 2007, doi 10.1145/1276377.1276406"}};
  return all;
}

std::unique_ptr<NormalsMethod> make_normals(const std::string& name) {
  if (name == "connectivity") return std::make_unique<Connectivity>();
  if (name == "york-simple") return std::make_unique<YorkSimple>();
  if (name == "york-quadratic") return std::make_unique<YorkQuadratic>();
  if (name == "york-cubic") return std::make_unique<YorkCubic>();
  if (name == "york-mass-matrix") return std::make_unique<MassMatrix>(false);
  if (name == "york-mass-matrix-kept") return std::make_unique<MassMatrix>(false, true);
  if (name == "york-mass-matrix-quadratic") return std::make_unique<MassMatrix>(true);
  if (name == "modern") return std::make_unique<CircleFit>();
  throw std::out_of_range("no method for normals is called " + name);
}

}  // namespace plumbline
