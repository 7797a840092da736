// Points of one material, each in a strained state of its own, strained further and asked for stress and energy.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "cases/harness/parts/probe_random.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

// A velocity gradient, and the strain rate around the axis of rings, 1/s.
struct Straining {
  Eigen::MatrixXd gradient;  // dim x dim
  double hoop = 0;
};

class MaterialProbe {
 public:
  // geometry: of geometry_names(). density: m_p / V_p of the undeformed points, kg/m^3.
  MaterialProbe(std::shared_ptr<const Material> material, std::size_t geometry, double density);

  const Material& material() const { return *material_; }
  const MaterialContext& context() const { return context_; }
  int dim() const { return context_.dim; }
  bool rings() const { return geometry_ == 2; }
  Columns& points() { return body_.points; }
  const Columns& points() const { return body_.points; }
  int count() const { return body_.points.points(); }

  // The same points, strained at `rate` for dt, s (may be negative), and their stresses where nothing strains them.
  MaterialProbe strained(const Straining& rate, double dt) const;
  // Each by a random gradient of about `strain`, in small steps.
  void strain_at_random(double strain, ProbeRandom& random);

  // Of point p. The stress is a tensor; power: V sigma : rate, W.
  Eigen::MatrixXd stress(int p) const;
  double hoop_stress(int p) const;
  double power(const Straining& rate, int p) const;
  double energy(int p) const { return material_->stored_energy(body_.points, {p, p + 1}); }
  double volume(int p) const { return body_.points(column::volume)[p]; }
  double density(int p) const { return body_.points(column::mass)[p] / volume(p); }
  double fastest(int p) const { return material_->step_bounds(body_.points, {p, p + 1}, dim()).fastest; }

  // Writes the rate of all points into their strain_rate column, or zero.
  void set_rate(const Straining& rate);
  void set_no_rate();
  // With the rates that the points have.
  void evaluate() { material_->evaluate_stress(body_.points, all_points(body_.points), context_); }
  Straining random_rate(ProbeRandom& random) const;

 private:
  void turn_tangents(const Eigen::MatrixXd& gradient, double dt);

  std::shared_ptr<const Material> material_;
  std::size_t geometry_;
  MaterialContext context_;
  Body body_;
};

}  // namespace plumbline
