// Functions of charts in space: their rates, and what their second rates have beside accelerations.

#include "oracle/proofs/ledger.hpp"
#include "oracle/proofs/spatial.hpp"

namespace lubjoint::proofs {

namespace {

const char* const charts = "charts in space";

/// A joint's axes t and n of body i and n_J of body j, the arms of its points P_i and P_j, and d = P_j − P_i with its
/// rate, all symbols; ω_i and ω_j as they turn.
struct Joint {
  SpatialSymbol t{"t"}, n{"n"}, n_j{"m"}, d{"d"}, d_rate{"d_dot"}, s_i{"s_i"}, s_j{"s_j"}, w_i{"w_i"}, w_j{"w_j"};

  /// The share of these in a rate.
  ex rate(const ex& f) const {
    ex sum = 0;
    const auto along = [&](const SpatialSymbol& at, const Spatial& by) {
      sum += f.diff(at.x) * by.x + f.diff(at.y) * by.y + f.diff(at.z) * by.z;
    };
    along(t, cross(w_i, t));
    along(n, cross(w_i, n));
    along(n_j, cross(w_j, n_j));
    along(s_i, cross(w_i, s_i));
    along(s_j, cross(w_j, s_j));
    along(d, d_rate);
    return sum;
  }
  /// σ = n·d/(n·n_J), β = t·n_J/(n·n_J).
  ex cosine() const { return dot(n, n_j); }
  ex sliding() const { return dot(n, d) / cosine(); }
  ex lean() const { return dot(t, n_j) / cosine(); }
  /// u = ṙ_j + ω_j × ρ_j − ṙ_i − ω_i × ρ_i with ρ_i = s_i + e, ρ_j = s_j − σ n_J: in it are only ḋ, e and σ n_J.
  Spatial relative(const ex& sigma) const {
    return Spatial(d_rate) - sigma * cross(w_j, n_j) - cross(w_i, Spatial(d) - sigma * Spatial(n_j));
  }
};

/// d/dt(t·e) = w·u, w = t − share · β n: what slides along the journal is not in it with the whole share.
void eccentricity_rate(Proof& proof, const ex& share) {
  const Joint y;
  const ex sigma = y.sliding();
  const Spatial w = Spatial(y.t) - share * y.lean() * Spatial(y.n);
  proof.equal(Algebra(), y.rate(dot(y.t, Spatial(y.d) - sigma * Spatial(y.n_j))), dot(w, y.relative(sigma)));
}

/// β̇ = w·((ω_j − ω_i) × n_J)/(n·n_J).
void lean_rate(Proof& proof) {
  const Joint y;
  const Spatial w = Spatial(y.t) - y.lean() * Spatial(y.n);
  proof.equal(Algebra(), y.rate(y.lean()), dot(w, cross(Spatial(y.w_j) - y.w_i, y.n_j)) / y.cosine());
}

/// d/dt(w·u) = w·(r̈_j + ω̇_j × ρ_j − r̈_i − ω̇_i × ρ_i) − γ, with
///   γ = −ẇ·u − w·(ω_j × (ω_j × ρ_j − σ̇ n_J) − ω_i × (ω_i × ρ_i + v_B)),   ẇ = ω_i × w − β̇ n.
/// σ and β are symbols, and so are their rates: the identity holds for any.
void eccentricity_gamma(Proof& proof, bool with_sliding_rate) {
  const Joint y;
  const symbol sigma("sigma"), sigma_rate("sigma_dot"), beta("beta"), beta_rate("beta_dot");
  const SpatialSymbol a("a"), alpha_i("alpha_i"), alpha_j("alpha_j");  // r̈_j − r̈_i, ω̇_i, ω̇_j
  const Spatial e = Spatial(y.d) - sigma * Spatial(y.n_j);
  const Spatial rho_i = Spatial(y.s_i) + e, rho_j = Spatial(y.s_j) - sigma * Spatial(y.n_j);
  const Spatial w = Spatial(y.t) - beta * Spatial(y.n);
  const Spatial d_second = Spatial(a) + cross(alpha_j, y.s_j) + cross(y.w_j, cross(y.w_j, y.s_j)) -
                           cross(alpha_i, y.s_i) - cross(y.w_i, cross(y.w_i, y.s_i));
  const auto rate = [&](const ex& f) {
    ex sum = y.rate(f) + f.diff(sigma) * sigma_rate + f.diff(beta) * beta_rate;
    const auto along = [&](const SpatialSymbol& at, const Spatial& by) {
      sum += f.diff(at.x) * by.x + f.diff(at.y) * by.y + f.diff(at.z) * by.z;
    };
    along(y.d_rate, d_second);
    along(y.w_i, alpha_i);
    along(y.w_j, alpha_j);
    return sum;
  };
  const Spatial v_b = Spatial(y.d_rate) - cross(y.w_i, y.d) - sigma * cross(Spatial(y.w_j) - y.w_i, y.n_j) -
                      sigma_rate * Spatial(y.n_j);
  const ex slid = with_sliding_rate ? ex(sigma_rate) : ex(0);
  const Spatial w_rate = cross(y.w_i, w) - beta_rate * Spatial(y.n);
  const Spatial left =
      cross(y.w_j, cross(y.w_j, rho_j) - slid * Spatial(y.n_j)) - cross(y.w_i, cross(y.w_i, rho_i) + v_b);
  const ex gamma = -dot(w_rate, y.relative(sigma)) - dot(w, left);
  const Spatial accelerations = Spatial(a) + cross(alpha_j, rho_j) - cross(alpha_i, rho_i);
  proof.equal(Algebra(), rate(dot(w, y.relative(sigma))), dot(w, accelerations) - gamma);
}

/// z = 2 atan(q_a/q₀) of a body's parameters q since an orientation, q_a = a·𝐪, ρ² = q₀² + q_a²:
///   ż = c·ω′,  c = (q₀² a + sign · q₀ a × 𝐪 + q_a 𝐪)/ρ²;   z̈ = c·ω̇′ − γ,  γ = ((ρ²)˙ c·ω′ − (ρ² c)˙·ω′/1)/ρ² with ω′
///   held.
void turn(Proof& proof, int sign, bool with_square_rate) {
  const MovingBody b("b");
  const SpatialSymbol a("axis");
  const ex q_a = dot(a, b.e);
  const ex square = pow(b.e0, 2) + pow(q_a, 2);
  const Spatial numerator = pow(b.e0, 2) * Spatial(a) + sign * b.e0 * cross(a, b.e) + q_a * Spatial(b.e);
  const ex once = b.rate(2 * GiNaC::atan(q_a / b.e0));
  proof.equal(Algebra(), once, dot(numerator, b.w) / square);
  const SpatialSymbol held("spin");  // ω′, not differentiated
  const ex numerator_rate =
      b.rate(dot(numerator, held)).subs(GiNaC::lst{held.x == b.w.x, held.y == b.w.y, held.z == b.w.z});
  const ex square_rate = with_square_rate ? b.rate(square) : ex(0);
  const ex gamma = (square_rate * dot(numerator, b.w) / square - numerator_rate) / square;
  proof.equal(Algebra(), b.rate(dot(numerator, b.w) / square), dot(numerator, b.alpha) / square - gamma);
}

}  // namespace

std::vector<Statement> spatial_chart_statements() {
  using enum Expectation;
  std::vector<Statement> all;
  all.push_back({charts, "d/dt(t.e) = w.u, w = t - (t.n_J)/(n.n_J) n: columns of a force w at X", "section 6", holds,
                 [](Proof& proof) { eccentricity_rate(proof, 1); }, "t and n fixed to the bearing's body"});
  all.push_back({charts, "the rate of (t.n_J)/(n.n_J)", "section 6", holds, lean_rate});
  all.push_back({charts, "t.e: gamma", "section 6", holds, [](Proof& proof) { eccentricity_gamma(proof, true); }});
  all.push_back({charts, "a turn, 2 atan2(a.q, q_0): row and gamma", "eq. 36", holds,
                 [](Proof& proof) { turn(proof, 1, true); }, "q the parameters since an orientation"});
  all.push_back({charts, "WRONG: d/dt(t.e) = t.u, with what slides along the journal", "section 6 altered", wrong,
                 [](Proof& proof) { eccentricity_rate(proof, 0); }});
  all.push_back({charts, "WRONG: t.e: gamma without the sliding rate", "section 6 altered", wrong,
                 [](Proof& proof) { eccentricity_gamma(proof, false); }});
  all.push_back({charts, "WRONG: a turn, q x a in place of a x q", "eq. 36 altered", wrong,
                 [](Proof& proof) { turn(proof, -1, true); }});
  all.push_back({charts, "WRONG: a turn, gamma without the rate of its square", "eq. 36 altered", wrong,
                 [](Proof& proof) { turn(proof, 1, false); }});
  return all;
}

}  // namespace lubjoint::proofs
