#include "cases/harness/parts/contact_gates.hpp"

#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "cases/harness/parts/encounter.hpp"
#include "cases/harness/parts/pair_gates.hpp"
#include "cases/harness/parts/parts.hpp"

namespace plumbline {
namespace {

constexpr int encounters = 20;
constexpr unsigned long contact_seed = 50;

template <int dim>
using NodeVelocities = std::vector<Eigen::Matrix<double, dim, 1>> VelocityField<dim>::*;

// The largest change of momentum at a node, over its mass.
template <int dim>
double momentum_off(const typename Encounter<dim>::Pass& pass, NodeVelocities<dim> of) {
  double worst = 0;
  for (std::size_t i = 0; i < pass.before[0].mass.size(); ++i) {
    Eigen::Matrix<double, dim, 1> change = Eigen::Matrix<double, dim, 1>::Zero();
    double mass = 0;
    for (std::size_t f = 0; f < pass.before.size(); ++f) {
      change += pass.before[f].mass[i] * ((pass.after[f].*of)[i] - (pass.before[f].*of)[i]);
      mass += pass.before[f].mass[i];
    }
    const double off = mass > 0 ? change.norm() / mass : 0;
    if (!(off <= worst)) worst = off;
  }
  return worst;
}

// The larger; what is no number stays.
template <int dim>
double momentum(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = 0;
  for (int k = 0; k < encounters; ++k) {
    const auto first = all.meet(Motion::any, random), again = all.meet_again(Motion::any, random),
               remapped = all.remap(random);
    for (const auto& pass : {first, again}) {
      worst = worse(momentum_off<dim>(pass, &VelocityField<dim>::start), worst);
      worst = worse(momentum_off<dim>(pass, &VelocityField<dim>::end), worst);
      worst = worse(momentum_off<dim>(pass, &VelocityField<dim>::midpoint), worst);
    }
    worst = worse(momentum_off<dim>(remapped, &VelocityField<dim>::remapped), worst);
  }
  return worst;
}

// What points gain beyond the work of the other forces, which goes through the mean of start and end; over m v^2 of the nodes.
// keep: points keep their own velocities and add the change; else they take the end's.
template <int dim>
double energy_gained(const std::vector<ContactChange<dim>>& told, bool keep) {
  double gained = 0, scale = 0;
  for (const ContactChange<dim>& c : told) {
    const auto kick = (c.end - c.start).eval(), mean = (0.5 * (c.start + c.end)).eval();
    const double own = keep ? kick.dot(c.own_start + 0.5 * kick)
                            : (c.end - c.own_start).dot(0.5 * (c.end + c.own_start));
    gained += c.mass * (own - (c.own_end - c.own_start).dot(mean));
    scale += c.mass * (c.own_start.squaredNorm() + c.own_end.squaredNorm());
  }
  return scale > 0 ? gained / scale : 0;
}

template <int dim>
double energy(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = -1;
  for (int k = 0; k < encounters; ++k) {
    const auto first = all.meet(Motion::approaching, random), again = all.meet_again(Motion::approaching, random);
    for (const auto& pass : {first, again}) {
      for (const bool keep : {false, true}) worst = worse(energy_gained<dim>(pass.told, keep), worst);
    }
    const auto remapped = all.remap(random);
    double gained = 0, scale = 0;
    for (std::size_t f = 0; f < remapped.before.size(); ++f) {
      for (std::size_t i = 0; i < remapped.before[f].mass.size(); ++i) {
        const double before = remapped.before[f].remapped[i].squaredNorm();
        gained += remapped.before[f].mass[i] * (remapped.after[f].remapped[i].squaredNorm() - before);
        scale += remapped.before[f].mass[i] * before;
      }
    }
    worst = worse(gained / scale, worst);
  }
  return worst;
}

// The strongest pull along x on a body by the other, which stands on its other side, as a change of speed.
template <int dim>
double tension(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = -1;
  for (int k = 0; k < encounters; ++k) {
    const auto pass = all.meet(Motion::approaching, random);
    for (std::size_t f = 0; f < pass.before.size(); ++f) {
      const double towards = f == 0 ? 1 : -1;
      all.for_nodes(pass.before[f], [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        worst = worse(towards * (pass.after[f].end[i] - pass.before[f].end[i])[0], worst);
      });
    }
  }
  return worst;
}

template <int dim>
double release(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = 0;
  for (int k = 0; k < encounters; ++k) {
    const auto pass = all.meet(Motion::parting, random);
    for (std::size_t f = 0; f < pass.before.size(); ++f) {
      for (const NodeVelocities<dim> of :
           {&VelocityField<dim>::start, &VelocityField<dim>::end, &VelocityField<dim>::midpoint}) {
        for (std::size_t i = 0; i < pass.before[f].mass.size(); ++i) {
          worst = worse(((pass.after[f].*of)[i] - (pass.before[f].*of)[i]).norm(), worst);
        }
      }
    }
  }
  return worst;
}

// What is left of the approach speed, at the node that both bodies share most.
template <int dim>
double approach(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = -1;
  for (int k = 0; k < encounters; ++k) {
    const auto pass = all.meet(Motion::approaching, random);
    std::size_t face = 0;
    for (std::size_t i = 0; i < pass.before[0].mass.size(); ++i) {
      const auto both = [&](std::size_t at) { return std::min(pass.before[0].mass[at], pass.before[1].mass[at]); };
      if (both(i) > both(face)) face = i;
    }
    const auto closing = [&](const auto& fields) { return (fields[0].midpoint[face] - fields[1].midpoint[face])[0]; };
    worst = worse(closing(pass.after) / closing(pass.before), worst);
  }
  return worst;
}

// By how much changes differ from what was told of them, and the midpoint from the mean of start and end.
template <int dim>
double untold(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  double worst = 0;
  for (int k = 0; k < encounters; ++k) {
    const auto first = all.meet(Motion::any, random), again = all.meet_again(Motion::any, random);
    for (const auto& pass : {first, again}) {
      for (std::size_t f = 0; f < pass.before.size(); ++f) {
        const VelocityField<dim>&before = pass.before[f], &after = pass.after[f];
        all.for_nodes(before, [&](int node) {
          const auto i = static_cast<std::size_t>(node);
          worst = worse((after.midpoint[i] - 0.5 * (after.start[i] + after.end[i])).norm(), worst);
          double off = (after.start[i] - before.start[i]).norm() + (after.end[i] - before.end[i]).norm();
          for (const ContactChange<dim>& c : pass.told) {
            if (c.node != node || c.mass != before.mass[i]) continue;
            off = (after.start[i] - c.start).norm() + (after.end[i] - c.end).norm() +
                  (before.end[i] - before.start[i] - c.own_end + c.own_start).norm();
          }
          worst = worse(off, worst);
        });
      }
    }
  }
  return worst;
}

// Nodes at which contact acts in one pass of a step and not in the other.
template <int dim>
double other_nodes(const ContactEntry& law) {
  Encounter<dim> all(law);
  ProbeRandom random(contact_seed);
  std::size_t count = 0;
  for (int k = 0; k < encounters; ++k) {
    std::set<int> nodes[2];
    for (const ContactChange<dim>& c : all.meet(Motion::any, random).told) nodes[0].insert(c.node);
    for (const ContactChange<dim>& c : all.meet_again(Motion::any, random).told) nodes[1].insert(c.node);
    for (const int node : nodes[0]) count += nodes[1].count(node) == 0 ? 1 : 0;
    for (const int node : nodes[1]) count += nodes[0].count(node) == 0 ? 1 : 0;
  }
  return static_cast<double>(count);
}

template <int dim>
void add_gates(const ContactEntry& law, const std::string& where, std::vector<MeasuredGate>& all) {
  const auto make = std::get<MakeContact<dim>>(law.make);
  if (!make) return;
  const auto row = [&](const std::string& family, const std::string& quantity, double bound, Origin origin,
                       const std::string& reason, const char* cause, double (*measure)(const ContactEntry&)) {
    all.push_back({family, gate_row(family, where, quantity, {{}, bound}, origin, reason), cause,
                   [&law, measure] { return plain(measure(law)); }});
  };
  const std::string of_random = ", of random velocities";
  row("momentum", "largest change of momentum at a node over its mass" + of_random, rounding_of_parts, Origin::identity,
      "what one body gets the other gives, node by node; a few thousand roundings",
      "impulses on two bodies are not opposite, or weighted with other masses", momentum<dim>);
  row("energy", "energy gained beyond the work of the other forces, over that of the nodes, where bodies approach",
      rounding_of_parts, Origin::theory,
      "contact without a store of its own may only take energy; a few thousand roundings",
      "a restitution, an impulse that is too strong, or another instant's velocity", energy<dim>);
  row("tension", "strongest pull on a body that approaches the other, as a change of speed", rounding_of_parts,
      Origin::theory, "contact pushes bodies apart and never together; a few thousand roundings",
      "normals that point the wrong way, or an impulse without a sign", tension<dim>);
  row("release", "largest change of a velocity where bodies part, at the start of the step and at its end", 0,
      Origin::theory, "bodies that part are let go",
      "contact is decided by where bodies are alone, or by the wrong velocity", release<dim>);
  row("told", "difference of changes and what is told of them, and of the midpoint and the mean of start and end",
      rounding_of_parts, Origin::identity, "the ledger books what is told; a few thousand roundings",
      "a change that is not told", untold<dim>);
  row("again", "nodes where contact acts in one force pass of a step and not in the other", 0, Origin::identity,
      "nodes are chosen once a step, or the passes do not converge", "a later pass chooses anew", other_nodes<dim>);
  if (!make(Encounter<dim>(law).grid(), 2)) return;  // the law that lets bodies pass
  row("approach", "share of the approach speed that is left where bodies touch", 1 - least_slowed, Origin::theory,
      "bodies that touch and approach are slowed down", "contact is not found, or does nothing", approach<dim>);
}

}  // namespace

std::vector<MeasuredGate> contact_gates(const ContactEntry& law) {
  if (law.by_pairs) return pair_gates(law);
  std::vector<MeasuredGate> all;
  add_gates<1>(law, "line", all);
  add_gates<2>(law, "plane", all);
  add_gates<3>(law, "space", all);
  return all;
}

}  // namespace plumbline
