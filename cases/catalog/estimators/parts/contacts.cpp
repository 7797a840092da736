// What gates of contact measure of laws that are wrong by known amounts.
#include <cmath>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/catalog/estimators/parts/reading.hpp"
#include "cases/harness/parts/contact_gates.hpp"

namespace plumbline {
namespace {

constexpr double contact_flaw = 0.03;  // m/s; speeds are about one
constexpr double left_over = 0.6;

// What a law does wrongly at every node that has mass of the first body, or of the second.
enum class ContactFlaw {
  start_momentum,  // momentum comes in: by `contact_flaw` times the mass of all bodies at the node, to one of them, at the start
  end_momentum,       // at the end
  midpoint_momentum,  // half way
  remapped_momentum,  // of velocities mapped anew
  scales_remapped,    // velocities mapped anew are 1 + contact_flaw times as large
  tells_kick,         // tells of one change of which points keep more than all forces give
  tells_end,          // of which they take more
  pulls_first,        // the first body towards the second, at the end
  pulls_second,
  lets_through,     // leaves a share of the approach speed, half way
  off_mean,         // half way is not the mean of start and end
  untold,           // changes start, end and the mean of both, and tells nothing
  tells_otherwise,  // changes nothing and tells of changes of start and end, and of another acceleration
  other_nodes       // acts at three nodes in the first pass of a step, and at two in another, one of them the same
};

// Of the one change that is told: m/s along the last direction.
constexpr double own_start = 0.7, own_end = -0.4, told_start = 0.2, told_kick_end = 0.9, told_end = -1.5;

template <int dim, ContactFlaw flaw>
class FlawedContact final : public Contact<dim> {
 public:
  using typename Contact<dim>::Vec;
  using typename Contact<dim>::Fields;
  using typename Contact<dim>::Visit;

  void find(const Scene&, const std::vector<std::size_t>&, const Fields&) override {}
  bool changes_start() const override { return true; }

  void apply(Fields& fields, double, bool decide, const Visit& visit) override {
    if (flaw == ContactFlaw::tells_kick || flaw == ContactFlaw::tells_end) {
      const double end = flaw == ContactFlaw::tells_kick ? told_kick_end : told_end;
      visit({0, 2, along(own_start), along(own_end), along(told_start), along(end)});
    }
    if (flaw == ContactFlaw::other_nodes) {
      for (const int node : decide ? std::vector{1, 2, 3} : std::vector{3, 4})
        visit({node, 1, along(0), along(0), along(0), along(0)});
    }
    for (std::size_t i = 0; i < fields[0].mass.size(); ++i) alter(fields, i, visit);
  }
  void apply_to_remapped(Fields& fields) override {
    for (std::size_t i = 0; i < fields[0].mass.size(); ++i) {
      if (flaw == ContactFlaw::remapped_momentum && fields[0].mass[i] > 0) fields[0].remapped[i] += gained(fields, i);
      if (flaw != ContactFlaw::scales_remapped) continue;
      for (auto& field : fields) field.remapped[i] *= 1 + contact_flaw;
    }
  }

 private:
  static Vec along(double v) { return v * Vec::Unit(dim - 1); }
  static Vec gained(const Fields& fields, std::size_t i) {
    return along(contact_flaw * (fields[0].mass[i] + fields[1].mass[i]) / fields[0].mass[i]);
  }

  static void alter(Fields& fields, std::size_t i, const Visit& visit) {
    auto &a = fields[0], &b = fields[1];
    if (a.mass[i] > 0 && flaw == ContactFlaw::start_momentum) a.start[i] += gained(fields, i);
    if (a.mass[i] > 0 && flaw == ContactFlaw::end_momentum) a.end[i] += gained(fields, i);
    if (a.mass[i] > 0 && flaw == ContactFlaw::midpoint_momentum) a.midpoint[i] += gained(fields, i);
    if (flaw == ContactFlaw::pulls_first) a.end[i][0] += contact_flaw;
    if (flaw == ContactFlaw::pulls_second) b.end[i][0] -= contact_flaw;
    if (flaw == ContactFlaw::lets_through) a.midpoint[i] = b.midpoint[i] + left_over * (a.midpoint[i] - b.midpoint[i]);
    if (flaw == ContactFlaw::off_mean) b.midpoint[i] += along(contact_flaw);
    if (flaw == ContactFlaw::untold) {
      b.start[i] += along(contact_flaw);
      b.end[i] -= along(2 * contact_flaw);
      b.midpoint[i] -= along(contact_flaw / 2);
    }
    if (flaw == ContactFlaw::tells_otherwise && b.mass[i] > 0) {
      const Vec faster = along(4 * contact_flaw);
      visit({static_cast<int>(i), b.mass[i], b.start[i], b.end[i] + faster, b.start[i] - along(contact_flaw),
             b.end[i] + along(2 * contact_flaw)});
    }
  }
};

template <int dim, ContactFlaw flaw>
std::unique_ptr<Contact<dim>> make_flawed(const Grid<dim>&, int) {
  return std::make_unique<FlawedContact<dim, flaw>>();
}

template <ContactFlaw flaw>
void add_readings(const std::string& family, double exact, KnownAnswers& all) {
  ContactEntry law;
  law.name = "flawed";
  law.make = {make_flawed<1, flaw>, make_flawed<2, flaw>, make_flawed<3, flaw>};
  for (const char* const where : {"line", "plane", "space"}) {
    const std::string row = family + "/" + where;
    all.push_back({std::to_string(static_cast<int>(flaw)) + "." + row, reading(contact_gates(law), row), exact});
  }
}

// What points gain of the one change that is told, over what they have, less the work of the other forces.
double kept_gain(double end) {
  const double kick = end - told_start, work = (own_end - own_start) * (told_start + end) / 2;
  return (kick * (own_start + kick / 2) - work) / (own_start * own_start + own_end * own_end);
}
double taken_gain(double end) {
  const double work = (own_end - own_start) * (told_start + end) / 2;
  return ((end * end - own_start * own_start) / 2 - work) / (own_start * own_start + own_end * own_end);
}

}  // namespace

KnownAnswers contact_answers() {
  KnownAnswers all;
  add_readings<ContactFlaw::start_momentum>("momentum", contact_flaw, all);
  add_readings<ContactFlaw::end_momentum>("momentum", contact_flaw, all);
  add_readings<ContactFlaw::midpoint_momentum>("momentum", contact_flaw, all);
  add_readings<ContactFlaw::remapped_momentum>("momentum", contact_flaw, all);
  add_readings<ContactFlaw::scales_remapped>("energy", 2 * contact_flaw + contact_flaw * contact_flaw, all);
  add_readings<ContactFlaw::tells_kick>("energy", kept_gain(told_kick_end), all);
  add_readings<ContactFlaw::tells_end>("energy", taken_gain(told_end), all);
  add_readings<ContactFlaw::pulls_first>("tension", contact_flaw, all);
  add_readings<ContactFlaw::pulls_second>("tension", contact_flaw, all);
  add_readings<ContactFlaw::pulls_first>("release", contact_flaw, all);
  add_readings<ContactFlaw::off_mean>("release", contact_flaw, all);
  add_readings<ContactFlaw::untold>("release", 2 * contact_flaw, all);
  add_readings<ContactFlaw::lets_through>("approach", left_over, all);
  add_readings<ContactFlaw::off_mean>("told", contact_flaw, all);
  add_readings<ContactFlaw::untold>("told", 3 * contact_flaw, all);
  add_readings<ContactFlaw::tells_otherwise>("told", 7 * contact_flaw, all);
  // Of twenty encounters: nodes 1 and 2 of the first pass, node 4 of the other.
  add_readings<ContactFlaw::other_nodes>("again", 20 * 3, all);
  return all;
}

}  // namespace plumbline
