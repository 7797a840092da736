#include "cases/harness/parts/material_gates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cases/harness/parts/material_change.hpp"
#include "cases/harness/parts/material_waves.hpp"
#include "cases/harness/parts/parts.hpp"
#include "cases/harness/parts/shape_probe.hpp"

namespace plumbline {
namespace {

constexpr int states = 5;  // strained at random, all points each
constexpr unsigned long materials_seed = 70;
constexpr double strain = 0.2;
constexpr double most_excess = 1;
constexpr double speeds_agree = 1e-2;  // at small strains moduli differ by a few of them from those at rest

// The largest of what `measure` finds of points strained at random.
double of_states(const MaterialSubject& subject, std::size_t geometry,
                 const std::function<double(const MaterialProbe&, ProbeRandom&)>& measure, double by = strain) {
  ProbeRandom random(materials_seed);
  double worst = 0;
  for (const auto& material : subject.made) {
    for (int k = 0; k < states; ++k) {
      MaterialProbe probe(material, geometry, subject.density);
      probe.strain_at_random(by, random);
      worst = worse(measure(probe, random), worst);
    }
  }
  return worst;
}

// dE - V sigma : rate dt of each point, over what the power could be.
double off_power(const MaterialProbe& probe, ProbeRandom& random) {
  const Straining rate = probe.random_rate(random);
  const Change change(probe, rate);
  double worst = 0;
  for (int p = 0; p < probe.count(); ++p) {
    const double stress = probe.stress(p).norm() + std::abs(probe.hoop_stress(p));
    const double scale = probe.volume(p) * stress * (rate.gradient.norm() + std::abs(rate.hoop));
    const double off = change.of([p](const MaterialProbe& at) { return at.energy(p); }) - probe.power(rate, p);
    if (off != 0) worst = worse(std::abs(off) / scale, worst);
  }
  return worst;
}

// What advance() says is stored less the change of what is, over the latter's size.
double off_told(const MaterialProbe& probe, ProbeRandom& random) {
  MaterialProbe after = probe;
  const PointRange all = all_points(after.points());
  const double before = after.material().stored_energy(after.points(), all);
  after.set_rate(probe.random_rate(random));
  const double told = after.material().advance(after.points(), all, after.context(), 0.01);
  const double now = after.material().stored_energy(after.points(), all);
  const double off = std::abs(told - (now - before));
  return off == 0 ? 0 : off / std::max(std::abs(now), std::abs(before));
}

// Rates of change of the internal variables less what advance() does, over the largest of each column.
double off_rates(const MaterialProbe& probe, ProbeRandom& random) {
  MaterialProbe now = probe;
  const Straining rate = probe.random_rate(random);
  now.set_rate(rate);
  const std::vector<double> rates = now.material().rates(now.points(), now.context());
  const Change change(probe, rate);
  double worst = 0;
  std::size_t k = 0;
  for (const ColumnId* id : now.material().internal_variables(now.context())) {
    double off = 0, scale = 0;
    for (std::size_t i = 0; i < now.points().values(*id).size(); ++i, ++k) {
      const double found = change.of([&](const MaterialProbe& at) { return at.points().values(*id)[i]; });
      off = worse(std::abs(rates.at(k) - found), off);
      scale = std::max(scale, std::abs(found));
    }
    if (off > 0) worst = worse(off / scale, worst);
  }
  return k == rates.size() ? worst : std::numeric_limits<double>::quiet_NaN();
}

// Under a spin w a stress turns with the material, d sigma = w sigma - sigma w, and nothing is stored.
double off_spin(const MaterialProbe& probe, ProbeRandom& random) {
  const Eigen::MatrixXd any = probe.random_rate(random).gradient, spin = any - any.transpose();
  const MaterialProbe after = probe.strained({spin, 0}, step_of_difference),
                      before = probe.strained({spin, 0}, -step_of_difference);
  double worst = 0;
  for (int p = 0; p < probe.count(); ++p) {
    const Eigen::MatrixXd sigma = probe.stress(p),
                          change = (after.stress(p) - before.stress(p)) / (2 * step_of_difference);
    const double scale = sigma.norm() * spin.norm();
    if (scale == 0) continue;
    worst = worse((change - (spin * sigma - sigma * spin)).norm() / scale, worst);
    const double stored = (after.energy(p) - before.energy(p)) / (2 * step_of_difference);
    worst = worse(std::abs(stored) / (probe.volume(p) * scale), worst);
  }
  return worst;
}

// Power of what a rate adds to the stress, over its size: negative where it would give energy. Its sign is turned.
double entropy_taken(const MaterialProbe& probe, ProbeRandom& random) {
  const Straining rate = probe.random_rate(random);
  MaterialProbe flowing = probe;
  flowing.set_rate(rate);
  flowing.evaluate();
  double worst = 0;
  for (int p = 0; p < probe.count(); ++p) {
    const Eigen::MatrixXd added = flowing.stress(p) - probe.stress(p);
    const double hoop = flowing.hoop_stress(p) - probe.hoop_stress(p);
    const double scale = (probe.stress(p).norm() + added.norm()) * rate.gradient.norm();
    if (scale > 0) worst = worse(-(added.cwiseProduct(rate.gradient).sum() + hoop * rate.hoop) / scale, worst);
  }
  return worst;
}

// Heat by viscosity, as it is told, less the power of what a rate adds to the stress; over the power of the whole stress.
double off_heat(const MaterialProbe& probe, ProbeRandom& random) {
  const Straining rate = probe.random_rate(random);
  MaterialProbe flowing = probe;
  flowing.set_rate(rate);
  flowing.evaluate();
  const Columns& points = flowing.points();
  const double told = flowing.material().viscous_heat(points, all_points(points), flowing.context(), 1);
  double power = 0, scale = 0;
  for (int p = 0; p < probe.count(); ++p) {
    power += flowing.power(rate, p) - probe.power(rate, p);
    scale += flowing.volume(p) * flowing.stress(p).norm() * rate.gradient.norm();
  }
  return told == power ? 0 : std::abs(told - power) / scale;
}

// Heat that straining at a rate takes back from a point, over the energy that it has.
double cooled(const MaterialProbe& probe, ProbeRandom& random) {
  const MaterialProbe after = probe.strained(probe.random_rate(random), 0.01);
  const auto heat = [](const MaterialProbe& at, int p) { return at.material().heat(at.points(), {p, p + 1}); };
  double worst = 0;
  for (int p = 0; p < probe.count(); ++p) worst = worse((heat(probe, p) - heat(after, p)) / after.energy(p), worst);
  return worst;
}

// States that no material may be in and that are not named as the point's, and good ones that are.
double unnamed(const MaterialProbe& probe, ProbeRandom&) {
  int wrong = probe.material().first_fault(probe.points(), all_points(probe.points())).point == -1 ? 0 : 1;
  const auto spoilt = [&](const ColumnId& id, int component, double value) {
    MaterialProbe bad = probe;
    const int p = probe.count() / 2;
    bad.points()(id, component)[p] = value;
    bad.evaluate();
    const Material::Fault fault = bad.material().first_fault(bad.points(), all_points(bad.points()));
    wrong += fault.point == p && !fault.field.empty() && !fault.reason.empty() ? 0 : 1;
  };
  for (const ColumnId* id : probe.material().internal_variables(probe.context())) {
    for (int k = 0; k < probe.points().components(*id); ++k) {
      for (const double none : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        spoilt(*id, k, none);
      }
    }
  }
  for (const ColumnId* positive : {&column::density, &column::energy}) {
    if (probe.points().has(*positive)) spoilt(*positive, 0, -1);
  }
  if (probe.points().has(column::deformation)) spoilt(column::deformation, 0, -5);  // turned inside out
  return wrong;
}

using OfState = double (*)(const MaterialProbe&, ProbeRandom&);

class Rows {
 public:
  Rows(const std::shared_ptr<const MaterialSubject>& subject, std::size_t geometry)
      : subject_(subject),
        geometry_(geometry) {}

  void add(const std::string& family, const std::string& name, const std::string& quantity, double bound, Origin origin,
           const std::string& reason, const char* cause, OfState measure) {
    add(family, name, quantity, bound, origin, reason, cause,
        [measure](const MaterialSubject& subject, std::size_t geometry) {
          return of_states(subject, geometry, measure);
        });
  }
  void add(const std::string& family, const std::string& name, const std::string& quantity, double bound, Origin origin,
           const std::string& reason, const char* cause,
           const std::function<double(const MaterialSubject&, std::size_t)>& measure) {
    all_.push_back(
        {family, gate_row(family, name + "/" + geometry_names()[geometry_], quantity, {{}, bound}, origin, reason),
         cause, [subject = subject_, geometry = geometry_, measure] { return plain(measure(*subject, geometry)); }});
  }
  std::vector<MeasuredGate> take() { return std::move(all_); }

 private:
  std::shared_ptr<const MaterialSubject> subject_;
  std::size_t geometry_;
  std::vector<MeasuredGate> all_;
};

const std::string by_difference = "; by differences of 1e-5 in strain, whose own errors are below 1e-7";

std::vector<MeasuredGate> gates_of(const std::shared_ptr<const MaterialSubject>& subject, std::size_t geometry) {
  Rows rows(subject, geometry);
  const Material& first = *subject->made.front();
  const bool turns = geometry == 1 || geometry == 3, waves = geometry != 2;
  if (first.store() != Store::none) {
    rows.add("energy", "derivative",
             "dE/dt less V sigma : rate of points strained by up to 0.2 at random rates, relative", of_difference,
             Origin::theory, "the stress is the derivative of the energy" + by_difference,
             "a modulus or a term of the stress that is not the energy's, or the volume of another state", off_power);
    rows.add("energy", "told", "energy that advance() tells it stored less the change of what is stored, relative",
             rounding_of_parts, Origin::identity, "the ledger books what is told; roundings",
             "what is stored is of another state", off_told);
  }
  rows.add("rates", "advance", "rates of the internal variables less what advance() makes of them, relative",
           of_difference, Origin::theory, "methods of lines take rates for what other steps advance" + by_difference,
           "rates and advance() are not of one equation", off_rates);
  if (turns) {
    rows.add("frame", "spin", "change of the stress under a spin w less w sigma - sigma w, and of the energy, relative",
             of_difference, Origin::theory, "a material does not know how it is turned" + by_difference,
             "strains that are added up in fixed axes", off_spin);
  }
  if (waves) {
    rows.add("speed", "small-strains",
             "how much faster the fastest plane wave is than the step takes it to be; strains of 0.001", speeds_agree,
             Origin::theory,
             "no wave may be faster than the step is made for; a strain of a thousandth changes it by some thousandths",
             "a modulus, or the density, of step_bounds() or of the stress", too_slow);
    rows.add(
        "speed", "excess",
        "speed that the step is made for over that of the fastest plane wave, less 1; strains of 0.001", most_excess,
        Origin::requirement,
        "a bound may be above the speed of waves, but one of twice that speed takes twice the steps that are needed",
        "a modulus, or the density, of step_bounds() or of the stress", too_fast);
    rows.add("speed", "strained",
             "how much faster the fastest plane wave is than the step takes it to be; strains up to 0.2", of_difference,
             Origin::theory, "no wave may be faster than the step is made for" + by_difference,
             "step_bounds() forgets how strains change the tangent", overtaken);
  }
  rows.add("speed", "motion", "what a velocity adds to the speed that the step is made for, less it, relative",
           rounding_of_parts, Origin::identity, "waves are carried along by the points; roundings",
           "step_bounds() forgets velocities", off_motion);
  rows.add("entropy", "production", "power that what rates add to the stress would give, relative, at random rates",
           rounding_of_parts, Origin::theory, "viscous stresses only take; roundings",
           "a viscosity with the wrong sign, or of bulk too small", entropy_taken);
  rows.add("entropy", "told",
           "heat by viscosity, as it is told, less the power of what rates add to the stress, relative",
           rounding_of_parts, Origin::identity, "the ledger tells it apart; roundings",
           "another part of the stress is told", off_heat);
  if (first.dissipates()) {
    rows.add("entropy", "heat", "heat that straining at random rates takes back, over the energy of the point",
             rounding_of_parts, Origin::theory, "dissipation is never negative; roundings",
             "plastic flow against the stress, or a sign of the heat", cooled);
  }
  rows.add("faults", "named", "inadmissible states that are not named as the point's, and good ones that are", 0,
           Origin::identity,
           "values that are no numbers, densities and energies below zero and points turned inside out end a run",
           "first_fault() leaves a column out", unnamed);
  return rows.take();
}

}  // namespace

std::vector<MeasuredGate> material_gates(const MaterialEntry& entry) {
  const auto subject = std::make_shared<const MaterialSubject>(entry);
  const Material& first = *subject->made.front();
  std::vector<MeasuredGate> all;
  for (std::size_t geometry = 0; geometry < geometry_names().size(); ++geometry) {
    if (first.chain() && geometry != 1) continue;    // a line of points in the plane
    if (first.surface() && geometry != 3) continue;  // a surface in space
    const bool pulls = first.measure() == StressMeasure::point_force;
    if (pulls && geometry == 2) continue;  // forces between rings are no sums of pulls
    std::vector<MeasuredGate> some = pulls ? pulling_gates(subject, geometry) : gates_of(subject, geometry);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  for (MeasuredGate& row : all) {
    for (const MaterialEntry::KnownFailure& known : entry.known_failures) {
      if (known.gate == row.gate.id)
        row.gate.expected_failure = ExpectedFailure{known.cause, {known.low, known.high}, {}, {}};
    }
  }
  return all;
}

}  // namespace plumbline
