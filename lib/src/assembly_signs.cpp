#include "assembly_signs.hpp"

#include <algorithm>
#include <cmath>

#include "lubjoint/joint/planar_motion.hpp"

namespace lubjoint::detail {

namespace {

using State = std::vector<double>;

/// Below this share of its sides a triangle is none, and a way along a guide is across it.
constexpr double flat = 1e-6;

Vector2<double> place_of(const SceneAnchor& at, const State& y) {
  const PlanarMotion<double> body = motion_in(y, at.body);
  return Vector2<double>(body.position + inertial_vector(body, at.point));
}

/// A pin and one of its sides.
struct Side {
  const SceneConstraint* pin;
  const Revolute<double>* places;
  SceneAnchor at;
};

/// A sign that may tell branches apart.
struct Candidate {
  AssemblySign sign;
  std::vector<int> values;  ///< of the branches
  bool same_ends = false;   ///< are its first and last joints at the same places in all branches?
};

int sign_of(double value, double size) { return std::abs(value) <= flat * size ? 0 : value > 0 ? 1 : -1; }

std::vector<Side> sides_on(const Scene& scene, std::size_t body) {
  std::vector<Side> sides;
  for (const SceneConstraint& each : scene.constraints) {
    const auto* pin = std::get_if<Revolute<double>>(&each.constraint);
    if (pin == nullptr) continue;
    if (pin->first.body == body) sides.push_back({&each, pin, pin->first});
    if (pin->second.body == body) sides.push_back({&each, pin, pin->second});
  }
  return sides;
}

class Candidates {
 public:
  Candidates(const Scene& scene, double length, const std::vector<AssemblyBranch>& branches)
      : scene_(scene), length_(length), branches_(branches) {
    for (const SceneConstraint& each : scene.constraints) {
      const auto* pin = std::get_if<Revolute<double>>(&each.constraint);
      if (pin == nullptr) continue;
      add_dyads(each, *pin);
      add_ways(each, *pin, pin->first.body, pin->second.body);
      add_ways(each, *pin, pin->second.body, pin->first.body);
    }
    std::stable_partition(list_.begin(), list_.end(), [](const Candidate& c) { return c.same_ends; });
  }
  const std::vector<Candidate>& list() const { return list_; }

 private:
  bool stays(const SceneAnchor& at) const {
    return std::all_of(branches_.begin(), branches_.end(), [&](const AssemblyBranch& b) {
      return (place_of(at, b.state) - place_of(at, branches_.front().state)).norm() <= 1e-6 * length_;
    });
  }

  /// Two bodies that a pin joins, each with another pin: the sense of the triangle.
  void add_dyads(const SceneConstraint& named, const Revolute<double>& pin) {
    if (pin.first.on_ground() || pin.second.on_ground()) return;
    for (const Side& a : sides_on(scene_, pin.first.body)) {
      for (const Side& c : sides_on(scene_, pin.second.body)) {
        if (a.pin == &named || c.pin == &named || a.pin == c.pin) continue;
        Candidate candidate;
        candidate.sign.name = a.pin->name + ", " + named.name + ", " + c.pin->name;
        candidate.same_ends = stays(a.at) && stays(c.at);
        for (const AssemblyBranch& branch : branches_) {
          const Vector2<double> p = place_of(pin.first, branch.state);
          const Vector2<double> first = p - place_of(a.at, branch.state);
          const Vector2<double> second = place_of(c.at, branch.state) - p;
          candidate.values.push_back(
              sign_of(first.x() * second.y() - first.y() * second.x(), first.norm() * second.norm()));
        }
        list_.push_back(std::move(candidate));
      }
    }
  }

  /// A body with a pin to another that a guide holds: the way from another pin of the body, along the guide.
  void add_ways(const SceneConstraint& named, const Revolute<double>& pin, std::size_t body, std::size_t guided) {
    if (body == ground_body || guided == ground_body) return;
    for (const SceneConstraint& each : scene_.constraints) {
      const auto* guide = std::get_if<Translational<double>>(&each.constraint);
      if (guide == nullptr || (guide->first.body != guided && guide->second.body != guided)) continue;
      for (const Side& a : sides_on(scene_, body)) {
        if (a.pin == &named) continue;
        Candidate candidate;
        candidate.sign = AssemblySign{a.pin->name + " to " + named.name + " along " + each.name, true};
        candidate.same_ends = stays(a.at);
        for (const AssemblyBranch& branch : branches_) {
          const Vector2<double> way = place_of(pin.first, branch.state) - place_of(a.at, branch.state);
          const Vector2<double> axis = inertial_vector(motion_in(branch.state, guide->first.body), guide->axis);
          candidate.values.push_back(sign_of(way.dot(axis), way.norm()));
        }
        list_.push_back(std::move(candidate));
      }
    }
  }

  const Scene& scene_;
  double length_;
  const std::vector<AssemblyBranch>& branches_;
  std::vector<Candidate> list_;
};

}  // namespace

void find_signs(const Scene& closed, double length, SceneAssembly& assembly) {
  std::vector<AssemblyBranch>& branches = assembly.branches;
  const Candidates candidates(closed, length, branches);
  const auto take = [&](const Candidate& candidate) {
    assembly.signs.push_back(candidate.sign);
    for (std::size_t i = 0; i < branches.size(); ++i) branches[i].signs.push_back(candidate.values[i]);
  };
  const auto apart = [&](std::size_t i, std::size_t j, const Candidate* candidate) {
    return candidate != nullptr ? candidate->values[i] != candidate->values[j] : branches[i].signs != branches[j].signs;
  };
  while (true) {
    const Candidate* best = nullptr;
    std::size_t most = 0;
    for (const Candidate& candidate : candidates.list()) {
      std::size_t newly = 0;
      for (std::size_t i = 0; i < branches.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) newly += !apart(i, j, nullptr) && apart(i, j, &candidate) ? 1 : 0;
      }
      if (newly > most) {
        most = newly;
        best = &candidate;
      }
    }
    if (best == nullptr) break;
    take(*best);
  }
  if (assembly.signs.empty() && !candidates.list().empty()) take(candidates.list().front());
}

}  // namespace lubjoint::detail
