// What gases alone have: pressures at the nodes, sharpening and its limits, densities, the exchange of energies.
#include <algorithm>
#include <cmath>

#include "tests/kernel/naive/step.hpp"

namespace plumbline {
namespace {

using Vec = NaiveStep::Vec;
using Mat = NaiveStep::Mat;

}  // namespace

template <class Visit>
void NaiveStep::for_face(std::size_t i, int d, Visit&& visit) const {
  const double sixth[] = {1, -8, 37, 37, -8, 1};
  std::vector<std::optional<std::size_t>> line;
  double most = 0, taken = 0;
  for (int k = -2; k <= 3; ++k) {
    line.push_back(beside(i, d, k));
    most = std::max(most, mass_of(line.back()));
  }
  const double below = mass_of(line[2]), above = mass_of(line[3]);
  const bool edge = below == 0 || above == 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double b = edge ? 0 : sixth[k] / 60 * std::min(1.0, 8 * mass_of(line[k]) / most);
    taken += b;
    if (b != 0) visit(*line[k], b);
  }
  if (below > 0) visit(*line[2], (1 - taken) * below / (below + above));
  if (above > 0) visit(*line[3], (1 - taken) * above / (below + above));
}

double NaiveStep::face_velocity(std::size_t i, int d, const std::vector<Vec>& u) const {
  double sum = 0;
  for_face(i, d, [&](std::size_t j, double b) { sum += b * u[j][d]; });
  return sum;
}

double NaiveStep::divergence(std::size_t p, Of which) const {
  straining_velocity(which);
  const std::vector<Vec>& faces = faces_[static_cast<std::size_t>(which)];
  double sum = 0;
  for_nodes_of(p, [&](const NaiveNode& node, double n, const Vec&) {
    const auto i = static_cast<std::size_t>(&node - nodes_.data());
    for (int d = 0; d < dim_; ++d) sum += n * (faces[i][d] - faces[*beside(i, d, -1)][d]) / h_;
  });
  return sum;
}

void NaiveStep::press_nodes() {
  std::vector<double> pressure(nodes_.size(), 0.0);
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    pressure[static_cast<std::size_t>(&i - nodes_.data())] -= p.volume * p.stress(0, 0) * n / i.volume;
  });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int d = 0; d < dim_; ++d) {
      const auto above = beside(i, d, 1);
      if (!above) continue;
      const double rise = pressure[*above] - pressure[i];
      for_face(i, d, [&](std::size_t j, double b) { nodes_[j].force[d] -= nodes_[j].volume / h_ * b * rise; });
    }
  }
}

NaiveStep::Overlaps NaiveStep::overlaps() const {
  const double places[] = {0.3399810435848563, 0.8611363115940526},
               weights[] = {0.6521451548625461, 0.3478548451374538};
  Overlaps sums{};
  for (int k = -3; k <= 3; ++k) {
    const auto at = static_cast<std::size_t>(k + 3);
    for (int piece = -4; piece < 4; ++piece) {
      for (int g = 0; g < 4; ++g) {
        const double u = piece / 2.0 + 0.25 * (1 + (g % 2 == 0 ? 1 : -1) * places[g / 2]);
        const double share = 0.25 * weights[g / 2] * spline(u, 0);
        sums.values[at] += share * spline(u - k, 0);
        sums.slopes[at] += share * slope(u - k, 0);
      }
    }
  }
  return sums;
}

double NaiveStep::Overlaps::gradient(const std::array<int, 3>& steps, int d, int dim) const {
  double product = 1;
  for (int e = 0; e < dim; ++e) {
    product *= (e == d ? slopes : values)[static_cast<std::size_t>(steps[static_cast<std::size_t>(e)] + 3)];
  }
  return product;
}

template <class Visit>
bool NaiveStep::for_overlapping(std::size_t i, Visit&& visit) const {
  const int across = dim_ > 1 ? 3 : 0, deep = dim_ > 2 ? 3 : 0;
  for (int c = -deep; c <= deep; ++c) {
    for (int b = -across; b <= across; ++b) {
      for (int a = -3; a <= 3; ++a) {
        std::optional<std::size_t> j = beside(i, 0, a);
        if (j && dim_ > 1) j = beside(*j, 1, b);
        if (j && dim_ > 2) j = beside(*j, 2, c);
        if (!j) return false;
        visit(*j, std::array<int, 3>{a, b, c});
      }
    }
  }
  return true;
}

double NaiveStep::even_share(const std::vector<double>& mapped, std::size_t i, double evenness) const {
  double least = mapped[i], most = mapped[i];
  const bool all = for_overlapping(i, [&](std::size_t j, const std::array<int, 3>&) {
    least = std::min(least, mapped[j]);
    most = std::max(most, mapped[j]);
  });
  const double apart = all && least > 0 ? (most - least) / (evenness * most) : 1;
  return std::pow(std::max(0.0, 1 - apart * apart), 2);
}

void NaiveStep::correct_forces() {
  std::vector<double> mapped(nodes_.size(), 0.0);
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    mapped[static_cast<std::size_t>(&i - nodes_.data())] -= p.volume * p.stress(0, 0) * n / i.volume;
  });
  std::vector<double> even = mapped;
  sharpen_densities(even);
  even_share_.assign(nodes_.size(), 0.0);
  for (auto& nodal : corrections_) nodal.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double chi = even_share(mapped, i, scene_.quadrature);
    even[i] *= chi;
    even_share_[i] = chi > 0 ? even[i] / mapped[i] : 0;
  }
  const Overlaps known = overlaps();
  for (std::size_t j = 0; j < nodes_.size(); ++j) {  // int N_j grad N_i
    if (even[j] == 0) continue;
    for_overlapping(j, [&](std::size_t i, const std::array<int, 3>& steps) {
      for (int d = 0; d < dim_; ++d) {
        nodes_[i].force[d] += even[j] * nodes_[j].volume / h_ * known.gradient(steps, d, dim_);
      }
    });
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    double here = 0;
    for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec&) {
      here += n * even[static_cast<std::size_t>(&i - nodes_.data())];
    });
    for (std::size_t k = first_pair_[p]; k < first_pair_[p + 1]; ++k) {
      nodes_[pairs_[k].node].force -= points[p].volume * here * pairs_[k].g;
    }
  }
}

double NaiveStep::correction(std::size_t p, Of which) const {
  const std::vector<Vec>& u = straining_velocity(which);
  std::vector<double>& nodal = corrections_[static_cast<std::size_t>(which)];
  if (nodal.empty()) {
    nodal.assign(nodes_.size(), 0.0);
    for (std::size_t q = 0; q < points.size(); ++q) {
      double divergence = 0;
      for_nodes_of(q, [&](const NaiveNode& i, double, const Vec& g) {
        divergence += g.dot(u[static_cast<std::size_t>(&i - nodes_.data())]);
      });
      for_nodes_of(q, [&](const NaiveNode& i, double n, const Vec&) {
        nodal[static_cast<std::size_t>(&i - nodes_.data())] -= points[q].volume * n * divergence / i.volume;
      });
    }
    const Overlaps known = overlaps();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (even_share_[i] == 0) {
        nodal[i] = 0;
        continue;
      }
      for_overlapping(i, [&](std::size_t j, const std::array<int, 3>& steps) {
        for (int d = 0; d < dim_; ++d) nodal[i] += u[j][d] / h_ * known.gradient(steps, d, dim_);
      });
      nodal[i] *= even_share_[i];
    }
  }
  double sum = 0;
  for_nodes_of(p, [&](const NaiveNode& i, double n, const Vec&) {
    sum += n * nodal[static_cast<std::size_t>(&i - nodes_.data())];
  });
  return sum;
}

double NaiveStep::wider_spline(double u) const {
  double sum = 0;
  const double start = u - 0.5, until = u + 0.5;
  std::vector<double> breaks{start, until};
  for (int k = -8; k <= 8; ++k) {
    if (k / 4.0 > start && k / 4.0 < until) breaks.push_back(k / 4.0);
  }
  std::sort(breaks.begin(), breaks.end());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double a = breaks[k], b = breaks[k + 1];
    sum += (b - a) / 6 * (spline(a, 0) + 4 * spline((a + b) / 2, 0) + spline(b, 0));
  }
  return sum;
}

Vec NaiveStep::flow_at(std::size_t p, Of which) const {
  Vec w = Vec::Zero();
  straining_velocity(which);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int d = 0; d < dim_; ++d) {
      Vec face = nodes_[i].x;
      face[d] += h_ / 2;
      if ((at_[p] - face).cwiseAbs().maxCoeff() >= 2.6 * h_) continue;
      double b = wider_spline((at_[p][d] - face[d]) / h_);
      for (int e = 0; e < dim_; ++e) b *= e == d ? 1 : spline((at_[p][e] - face[e]) / h_, 0);
      w[d] += b * faces_[static_cast<std::size_t>(which)][i][d];
    }
  }
  return w;
}

double NaiveStep::theta() const {
  return (boxes()                       ? 1.0 / 6 + 0.25 * 0.25 / 3
          : domains()                   ? 1.0 / 6 + 0.25 * 0.25
          : scene_.shape == "linear"    ? 1.0 / 6
          : scene_.shape == "quadratic" ? 1.0 / 4
                                        : 1.0 / 3) /
         2;
}

std::optional<std::size_t> NaiveStep::massive(std::size_t i, int d, int side) const {
  const auto j = beside(i, d, side);
  return j && nodes_[*j].m > 0 ? j : std::nullopt;
}

double NaiveStep::slope_at(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const {
  double sum = 0, weights = 0;
  const auto density = [&](std::size_t k) { return nodes_[k].m / nodes_[k].volume; };
  for (int side : {-1, 1}) {
    const auto j = massive(i, d, side);
    if (!j) continue;
    const double weight = by_density ? density(*j) / (density(i) + density(*j)) : 1;
    sum += weight * side * (u[*j][d] - u[i][d]) / h_;
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

double NaiveStep::linear_share(const std::vector<Vec>& u, std::size_t i, int d, bool by_density) const {
  const auto low = massive(i, d, -1), high = massive(i, d, 1);
  const double g = slope_at(u, i, d, by_density);
  if (!low || !high || g == 0) return 0;
  const double before = slope_at(u, *low, d, by_density) / g, after = slope_at(u, *high, d, by_density) / g;
  return std::clamp(std::min({(before + after) / 2, 2 * before, 2 * after}), 0.0, 1.0);
}

double NaiveStep::slopes_beside(const std::vector<Vec>& u, std::size_t i, int d) const {
  double relative = 0;
  for (const int side : {-1, 1}) {
    const auto j = massive(i, d, side);
    if (!j) continue;
    const double lighter = (nodes_[*j].m / nodes_[*j].volume) / (nodes_[i].m / nodes_[i].volume);
    relative += std::min(1.0, 8 * lighter) * slope_at(u, *j, d, true) / slope_at(u, i, d, true);
  }
  return std::clamp(std::abs(relative) - 1, 0.0, 1.0);
}

std::vector<Vec> NaiveStep::kept_of_sharpening() const {
  std::vector<Vec> kept(nodes_.size(), Vec::Ones());
  if (scene_.sharpening_in_expansion == 1) return kept;
  std::vector<Vec> u;
  for (const NaiveNode& node : nodes_) u.push_back(node.start);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int d = 0; d < dim_; ++d) {
      if (nodes_[i].m == 0 || slope_at(u, i, d, true) <= 0) continue;
      const auto density = [&](int side) {
        const auto j = massive(i, d, side);
        return j ? nodes_[*j].m / nodes_[*j].volume : 0.0;
      };
      const double low = density(-1), high = density(1);
      const double uneven = std::abs(high - low) / (high + low);
      const double bent = std::max(0.0, 1 - 2 * (1 - uneven) * linear_share(u, i, d, true));
      kept[i][d] -= (1 - scene_.sharpening_in_expansion) * bent * std::min(1.0, 32 * uneven) * slopes_beside(u, i, d);
    }
  }
  return kept;
}

std::vector<Vec> NaiveStep::sharpened(const std::vector<Vec>& u) const {
  std::vector<Vec> q = u;
  const std::vector<Vec> kept = kept_of_sharpening();
  for (int d = 0; d < dim_ && scene_.sharpening > 0; ++d) {
    std::vector<Vec> power = u;
    for (const double amount : {scene_.sharpening, scene_.sharpening_second, scene_.sharpening_third}) {
      std::vector<Vec> next(u.size(), Vec::Zero());
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        for (int side : {-1, 1}) {
          const auto j = beside(i, d, side);
          const double m = nodes_[i].m, other = j ? nodes_[*j].m : 0;
          if (!(m > 0 && other > 0)) continue;
          const double share = (kept[i][d] + kept[*j][d]) * theta() * other / (m + other);
          next[i] += share * (power[i] - power[*j]);
        }
        q[i] += amount * next[i];
      }
      power = next;
    }
  }
  return q;
}

void NaiveStep::sharpen_densities(std::vector<double>& rho) const {
  const double share = scene_.sharpened_density ? scene_.sharpening * theta() : 0;
  const std::vector<double> mapped = rho;
  for (int pass = 0; pass < 2 && share > 0; ++pass) {
    const std::vector<double> before = rho;
    const auto at = [&](std::optional<std::size_t> i) { return i ? before[*i] : 0.0; };
    for (std::size_t i = 0; i < rho.size(); ++i) {
      for (int d = 0; d < dim_ && mapped[i] > 0; ++d) {
        const auto j = beside(i, d, 1);
        if (!j || mapped[*j] == 0) continue;
        const double behind = at(beside(i, d, -1)), own = before[i], other = before[*j], ahead = at(beside(*j, d, 1));
        const double change = other - own, sign = change < 0 ? -1 : 1;
        const double most = share * std::min({std::abs(change), behind, own, other, ahead});
        const double flux = sign * std::max(0.0, std::min({most, sign * (own - behind), sign * (ahead - other)}));
        rho[i] -= flux;
        rho[*j] += flux;
      }
    }
  }
}

double NaiveStep::exchange_share(std::size_t i) const {
  double most = 0;
  for (int d = 0; d < dim_; ++d) {
    const auto below = beside(i, d, -1), above = beside(i, d, 1);
    const bool known = below && above && nodes_[*below].m > 0 && nodes_[*above].m > 0;
    if (!known) continue;
    const double a = nodes_[i].heat - nodes_[*below].heat, b = nodes_[i].heat - nodes_[*above].heat;
    const bool extreme = (a > 0 && b > 0) || (a < 0 && b < 0);
    const auto [less, more] = std::minmax({std::abs(a), std::abs(b)});
    if (extreme) most = std::max(most, std::min(less / more, 50 * less / nodes_[i].heat));
  }
  return (1 + 3 * most) / 4;
}

void NaiveStep::exchange(Of which, double dt) {
  for (NaivePoint& point : points) point.exchanged = 0;
  if (!gas_ || scene_.heat_exchange == 0) return;
  for (NaiveNode& node : nodes_) node.heat = node.alpha = 0;
  std::vector<double> closing;
  for (std::size_t p = 0; p < points.size(); ++p) closing.push_back(std::max(0.0, -strain_rate(p, which).trace()));
  const auto number = [&](const NaivePoint& p) { return static_cast<std::size_t>(&p - points.data()); };
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    i.heat += p.m * p.energy * n / i.m;
    i.alpha += scene_.heat_exchange * dt * p.m * n * closing[number(p)] / i.m;
  });
  std::vector<double> shares(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) shares[i] = nodes_[i].m > 0 ? exchange_share(i) : 0;
  for_pairs([&](NaivePoint& p, NaiveNode& i, double n, const Vec&) {
    const double share = shares[static_cast<std::size_t>(&i - nodes_.data())];
    p.exchanged += n * std::min(1.0, share * i.alpha) * (i.heat - p.energy);
  });
}

std::vector<double> NaiveStep::per_volume(const std::vector<double>& amounts) const {
  std::vector<double> nodal(nodes_.size(), 0.0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!apart(points[p].x, nodes_[i])) nodal[i] += amounts[p] * weight(points[p], nodes_[i]);
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) nodal[i] /= nodes_[i].volume;
  return nodal;
}

std::vector<double> NaiveStep::at_points(const std::vector<double>& nodal) const {
  std::vector<double> read(points.size(), 0.0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!apart(points[p].x, nodes_[i])) read[p] += weight(points[p], nodes_[i]) * nodal[i];
    }
  }
  return read;
}

void NaiveStep::densities() {
  if (!gas_) return;
  if (scene_.density == DensityMethod::grid) {
    std::vector<double> masses;
    for (const NaivePoint& point : points) masses.push_back(point.m);
    std::vector<double> nodal = per_volume(masses);
    sharpen_densities(nodal);
    const std::vector<double> read = at_points(nodal);
    for (std::size_t p = 0; p < points.size(); ++p) points[p].density = read[p];  // [EC-APIC 2]
  }
  for (NaivePoint& point : points) point.volume = point.m / point.density;
}

double NaiveStep::limited(std::size_t p, Of which) const {
  const std::vector<Vec>& u = straining_velocity(which);
  double sum = 0;
  for (std::size_t k = first_pair_[p]; k < first_pair_[p + 1]; ++k) {
    for (int d = 0; d < dim_; ++d) {
      const std::size_t i = pairs_[k].node;
      sum += pairs_[k].n * (1 - linear_share(u, i, d, false)) * std::max(0.0, -slope_at(u, i, d, false));
    }
  }
  return std::min(points[p].closing, sum);
}

bool NaiveStep::viscosity_would_cool() {
  bool any = false;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Mat e = strain_rate(p, Of::middle);
    const Mat viscous = points[p].stress +
                        points[p].pressure * Mat::Identity();  // zero, not a rounding, where nothing is
    const double heat = viscous.cwiseProduct(e).sum();
    if (heat >= 0) continue;
    points[p].stress = stress_of(p, e, 0, Of::middle);
    any = true;
  }
  for (std::size_t p = 0; p < points.size() && any; ++p) {  // forces are mapped again, with these rates
    points[p].closing = std::max(0.0, -strain_rate(p, Of::middle).trace());
  }
  return any;
}

}  // namespace plumbline
