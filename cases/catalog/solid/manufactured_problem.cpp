#include "cases/catalog/solid/manufactured_problem.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/run/judged_at_end.hpp"

namespace plumbline {
namespace {

using reference::ManufacturedSolution;
using reference::Tensor;
using reference::Vector;

constexpr int instants = 400;  // at which the error is taken, evenly spaced

std::span<const double> coordinates(const ManufacturedSolution& exact, const Vector<double>& x) {
  return {x.data(), static_cast<std::size_t>(exact.dimension())};
}

Vector<double> place(const Columns& points, int dim, int p) {
  Vector<double> x{};
  for (int d = 0; d < dim; ++d) x[static_cast<std::size_t>(d)] = points(column::position, d)[p];
  return x;
}

// For each place the number of the one where a quarter turn about the origin takes it, to a millionth of the largest coordinate;
// none if one of them has none.
std::vector<std::size_t> quarter_turned(const std::vector<Vector<double>>& places) {
  double largest = 0;
  for (const Vector<double>& x : places) largest = std::max({largest, std::abs(x[0]), std::abs(x[1])});
  const auto key = [&](double x, double y) {
    return std::pair(std::llround(1e6 * x / largest), std::llround(1e6 * y / largest));
  };
  std::map<std::pair<long long, long long>, std::size_t> number;
  for (std::size_t k = 0; k < places.size(); ++k) number[key(places[k][0], places[k][1])] = k;
  std::vector<std::size_t> images;
  for (const Vector<double>& x : places) {
    const auto found = number.find(key(-x[1], x[0]));
    if (found == number.end()) return {};
    images.push_back(found->second);
  }
  return images;
}

// Sums of squares over the components of a vector or tensor.
struct Difference {
  double squared = 0, scale = 0, bound = 0;
  double distance() const { return std::sqrt(squared); }
};

class ManufacturedProblem final : public Problem, public JudgedAtEnd {
 public:
  ManufacturedProblem(ManufacturedSetup setup, const Settings& settings)
      : settings_(settings),
        setup_(std::move(setup)) {
    const Columns& points = setup_.body.points;
    for (int p = 0; p < points.points(); ++p) start_.push_back(place(points, dim(), p));
  }

  double end_time() const override { return setup_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid = setup_.grid;
    Body body = setup_.body;
    start_motion(*setup_.exact, settings_.text("transfer") == "apic", body);
    if (setup_.loaded)
      body.load = [exact = setup_.exact, start = start_](double time, Columns& points, std::span<const int> id) {
        for (int p = 0; p < points.points(); ++p) {
          const auto& x = start[static_cast<std::size_t>(id[static_cast<std::size_t>(p)])];
          const Vector<double> b = exact->body_force(coordinates(*exact, x), time);
          for (int d = 0; d < exact->dimension(); ++d)
            points(column::body_force, d)[p] = b[static_cast<std::size_t>(d)];
        }
      };
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const double t = simulation.time();
    const bool last = end_time() - t <= 1e-12 * end_time();
    if (t < end_time() * static_cast<double>(seen_) / instants && !last) return;
    while (end_time() * static_cast<double>(seen_) / instants <= t) ++seen_;
    const auto [error, size] = displacement_error(simulation);
    largest_ = larger(largest_, size);
    times_.push_back(t);
    errors_.push_back(error);
    if (!(error <= worst_) && !std::isnan(worst_)) {
      worst_ = error;
      worst_time_ = t;
    }
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("seen", seen_);
    archive("worst", worst_);
    archive("worst_time", worst_time_);
    archive("largest", largest_);
    archive("times", times_);
    archive("errors", errors_);
  }

  std::vector<std::string> seen_on_the_way() const override {
    return {setup_.loaded ? "displacement.worst" : "energy_rise"};
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    if (!setup_.loaded) {
      return {scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"),
              scalar_measure("energy_lost", 1 - energy_.kept(), 0, 0, "1")};
    }
    std::vector<Measure> all{worst_measure(simulation)};
    std::vector<ErrorSample> displacement, velocity, stress;
    const Body& body = simulation.scene().bodies.front();
    for (int p = 0; p < body.points.points(); ++p) sample(simulation, p, displacement, velocity, stress);
    const auto add = [&](const char* name, const char* unit, const std::vector<ErrorSample>& samples) {
      for (Measure& m : error_norms(name, unit, samples)) all.push_back(std::move(m));
    };
    add("displacement", "m", displacement);
    add("velocity", "m/s", velocity);
    add("stress", "Pa", stress);
    if (const std::vector<std::size_t> images = setup_.turns ? quarter_turned(start_) : std::vector<std::size_t>{};
        !images.empty())
      all.push_back(share_measure("turned", turned_difference(body, images)));
    return all;
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {
        {"time", "s", "time", times_},
        {"displacement_error", "1",
         setup_.loaded ? "norm of the displacement's error" : "norm of the distance from the loaded motion", errors_}};
    return profile;
  }

 private:
  int dim() const { return setup_.exact->dimension(); }
  const Vector<double>& start_of(const Body& body, int p) const {
    return start_[static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)])];
  }

  // Of the displacement where the points started turned by 90 degrees and the turned one, over the largest.
  double turned_difference(const Body& body, const std::vector<std::size_t>& images) const {
    std::vector<Vector<double>> displacement(start_.size());
    for (int p = 0; p < body.points.points(); ++p) {
      const auto id = static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
      for (std::size_t d = 0; d < 2; ++d)
        displacement[id][d] = body.points(column::position, static_cast<int>(d))[p] - start_[id][d];
    }
    double apart = 0, largest = 0;
    for (std::size_t k = 0; k < images.size(); ++k) {
      const Vector<double>&u = displacement[k], &image = displacement[images[k]];
      apart = larger(apart, std::hypot(image[0] + u[1], image[1] - u[0]));
      largest = larger(largest, std::hypot(u[0], u[1]));
    }
    return apart / largest;
  }

  // Norms of the displacement's error and of the exact displacement.
  std::pair<double, double> displacement_error(const Simulation& simulation) const {
    const Body& body = simulation.scene().bodies.front();
    double sum = 0, size = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const Vector<double>& x = start_of(body, p);
      const Vector<double> u = setup_.exact->values(coordinates(*setup_.exact, x), simulation.time()).displacement;
      const double volume = body.points(column::volume)[p];
      for (int d = 0; d < dim(); ++d) {
        const auto k = static_cast<std::size_t>(d);
        const double error = body.points(column::position, d)[p] - x[k] - u[k];
        sum += volume * error * error;
        size += volume * u[k] * u[k];
      }
    }
    return {std::sqrt(sum), std::sqrt(size)};
  }

  // Its scale is the largest norm of the exact displacement.
  Measure worst_measure(const Simulation& simulation) const {
    const Body& body = simulation.scene().bodies.front();
    double bound = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const auto exact = setup_.exact->state(coordinates(*setup_.exact, start_of(body, p)), worst_time_);
      for (int d = 0; d < dim(); ++d) {
        const double u = exact.displacement[static_cast<std::size_t>(d)].bound;
        bound += body.points(column::volume)[p] * u * u;
      }
    }
    Measure worst;
    worst.name = "displacement.worst";
    worst.error = worst_;
    worst.scale = largest_;
    worst.reference_bound = std::sqrt(bound);
    worst.unit = dim() == 1 ? "m^1.5" : dim() == 2 ? "m^2" : "m^2.5";
    return worst;
  }

  void sample(const Simulation& simulation, int p, std::vector<ErrorSample>& displacement,
              std::vector<ErrorSample>& velocity, std::vector<ErrorSample>& stress) const {
    const Body& body = simulation.scene().bodies.front();
    const Columns& points = body.points;
    const Vector<double>& x = start_of(body, p);
    const auto exact = setup_.exact->state(coordinates(*setup_.exact, x), simulation.time());
    Tensor<double> f{};
    for (int k = 0; k < dim() * dim(); ++k) f[static_cast<std::size_t>(k)] = points(column::deformation, k)[p];
    const Tensor<double> piola = reference::first_piola<double>(
        f, dim(), reference::Lame<double>::from(setup_.exact->youngs_modulus(), setup_.exact->poisson()));
    Difference u, v, s;
    const auto add = [](Difference& to, double computed, const reference::Bounded& right) {
      to.squared += (computed - right.value) * (computed - right.value);
      to.scale += right.value * right.value;
      to.bound += right.bound * right.bound;
    };
    for (int d = 0; d < dim(); ++d) {
      const auto k = static_cast<std::size_t>(d);
      add(u, points(column::position, d)[p] - x[k], exact.displacement[k]);
      add(v, points(column::velocity, d)[p], exact.velocity[k]);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(dim() * dim()); ++k) add(s, piola[k], exact.stress[k]);
    const double volume = points(column::volume)[p];
    const auto push = [volume](std::vector<ErrorSample>& to, const Difference& of) {
      to.push_back({volume, of.distance(), std::sqrt(of.scale), std::sqrt(of.bound)});
    };
    push(displacement, u);
    push(velocity, v);
    push(stress, s);
  }

  Settings settings_;
  ManufacturedSetup setup_;
  std::vector<Vector<double>> start_;  // X by the point's number
  EnergyWatch energy_;
  long seen_ = 0;
  double worst_ = 0, worst_time_ = 0, largest_ = 0;
  std::vector<double> times_, errors_;
};

}  // namespace

std::shared_ptr<NeoHookean> material_of(const reference::ManufacturedSolution& exact) {
  auto material = std::make_shared<NeoHookean>();
  material->youngs_modulus = exact.youngs_modulus();
  material->poissons_ratio = exact.poisson();
  material->density = exact.density();
  return material;
}

Tensor<double> initial_velocity_gradient(const ManufacturedSolution& exact, const Vector<double>& position,
                                         double length) {
  const auto dim = static_cast<std::size_t>(exact.dimension());
  const double step = 1e-3 * length;
  const reference::Inverse<double> inverse(exact.values(coordinates(exact, position), 0).deformation,
                                           exact.dimension());
  Tensor<double> result{};
  for (std::size_t e = 0; e < dim; ++e) {
    const auto velocity = [&](double shift) {
      Vector<double> x = position;
      x[e] += shift * step;
      return exact.values(coordinates(exact, x), 0).velocity;
    };
    const Vector<double> far_left = velocity(-2), left = velocity(-1), right = velocity(1), far_right = velocity(2);
    for (std::size_t d = 0; d < dim; ++d) {
      const double rate = (8 * (right[d] - left[d]) - (far_right[d] - far_left[d])) / (12 * step);
      for (std::size_t k = 0; k < dim; ++k) result[d * dim + k] += rate * inverse.tensor[e * dim + k];
    }
  }
  return result;
}

void start_motion(const ManufacturedSolution& exact, bool affine, Body& body) {
  const int dim = exact.dimension();
  Columns& points = body.points;
  if (affine) points.add(column::affine, dim * dim);
  for (int p = 0; p < points.points(); ++p) {
    const Vector<double> x = place(points, dim, p);
    const auto now = exact.values(coordinates(exact, x), 0);
    const Tensor<double> gradient = affine ? initial_velocity_gradient(exact, x, 1) : Tensor<double>{};
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      points(column::position, d)[p] = x[k] + now.displacement[k];
      points(column::velocity, d)[p] = now.velocity[k];
    }
    for (int k = 0; k < dim * dim; ++k) {
      points(column::deformation, k)[p] = now.deformation[static_cast<std::size_t>(k)];
      if (affine) points(column::affine, k)[p] = gradient[static_cast<std::size_t>(k)];
    }
  }
}

std::unique_ptr<Problem> manufactured_problem(ManufacturedSetup setup, const Settings& settings) {
  return std::make_unique<ManufacturedProblem>(std::move(setup), settings);
}

}  // namespace plumbline
