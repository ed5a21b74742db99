#include "oracle/certified/film_coefficients.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "oracle/certified/equilibrium.hpp"
#include "oracle/certified/film_integrals.hpp"

namespace lubjoint::certified {

namespace {

/// F_r and F_t at a = ε, b = 0, and their slopes.
struct Slopes {
  PolarBalls value, by_epsilon, by_a, by_b;

  CoefficientBalls coefficients(const Ball& epsilon) const {
    return {-(by_epsilon.radial + by_a.radial),
            value.tangential / epsilon,
            -(by_epsilon.tangential + by_a.tangential),
            -(value.radial / epsilon),
            -by_b.radial,
            2 * by_a.radial,
            -by_b.tangential,
            2 * by_a.tangential};
  }
};

template <class Function>
Ball over(const Ball& epsilon, const ExtentBalls& window, const Function& f) {
  return integral([&](const ComplexBall& theta) { return f(Place(theta, epsilon)); }, window);
}

ComplexBall cubed(const Place& at) { return at.h * at.h * at.h; }
ComplexBall fourth(const Place& at) { return cubed(at) * at.h; }

/// F_r = ½∫g cosθ/H³, F_t = ½∫g sinθ/H³, g = a sinθ − 2b cosθ: zero at the ends of the dynamic film.
Slopes short_slopes(const Ball& epsilon, const ExtentBalls& film) {
  const Ball& a = epsilon;
  const Ball sc = over(epsilon, film, [](const Place& at) { return at.sine * at.cosine / cubed(at); });
  const Ball ss = over(epsilon, film, [](const Place& at) { return at.sine * at.sine / cubed(at); });
  const Ball cc = over(epsilon, film, [](const Place& at) { return at.cosine * at.cosine / cubed(at); });
  const Ball scc = over(epsilon, film, [](const Place& at) { return at.sine * at.cosine * at.cosine / fourth(at); });
  const Ball ssc = over(epsilon, film, [](const Place& at) { return at.sine * at.sine * at.cosine / fourth(at); });
  return {{a * sc / 2, a * ss / 2}, {-3 * a * scc / 2, -3 * a * ssc / 2}, {sc / 2, ss / 2}, {-cc, -sc}};
}

/// F = ∫w (G + C)/H³, G = a cosθ + 2b sinθ, w_r = −6 sinθ, w_t = 6 cosθ (6(1 + cosθ) where p(π) ≠ 0).
class LongSlopes {
 public:
  LongSlopes(Law law, const Ball& epsilon, const ExtentBalls& film)
      : law_(law), epsilon_(epsilon), film_(film), window_(film) {
    if (law == Law::long_half_eq5 || law == Law::long_full) window_ = {Ball(0), 2 * ball_pi()};
  }

  Slopes operator()() const {
    const Ball& a = epsilon_;
    const Ball j = constant_integral([](const Place& at) { return ComplexBall(Ball(1)) / cubed(at); });
    const Ball n_a = constant_integral([](const Place& at) { return at.cosine / cubed(at); });
    const Ball n_b = constant_integral([](const Place& at) { return Ball(2) * at.sine / cubed(at); });
    const Ball j_e = -3 * constant_integral([](const Place& at) { return at.cosine / fourth(at); });
    const Ball n_ae = -3 * constant_integral([](const Place& at) { return at.cosine * at.cosine / fourth(at); });
    const Ball c = -(a * n_a / j);
    const Ball c_a = -(n_a / j);
    const Ball c_e = -(a * (n_ae * j - n_a * j_e) / (j * j));
    Ball c_b = -(n_b / j);
    PolarBalls ends{Ball(0), Ball(0)};
    if (law_ == Law::long_dynamic) {
      // Both ends move by dθ/db = 2/a; the upper one is the minimum film.
      const Ball thin = Ball(1) - epsilon_;
      const Ball thick = Ball(1) + epsilon_;
      const Ball thin_3 = thin * thin * thin;
      const Ball thick_3 = thick * thick * thick;
      const Ball n_end = 2 * (-(Ball(1) / thin_3) - Ball(1) / thick_3);
      const Ball j_end = 2 / a * (Ball(1) / thin_3 - Ball(1) / thick_3);
      c_b = c_b - (n_end * j - a * n_a * j_end) / (j * j);
      ends.tangential = 2 / a * 6 * (-((c - a) / thin_3) - (c + a) / thick_3);
    }
    const ComplexBall cc(c), cc_a(c_a), cc_e(c_e), cc_b(c_b);
    const auto wave = [&](const Place& at) { return a * at.cosine + cc; };
    Slopes slopes{force([&](const Place& at) { return wave(at) / cubed(at); }), force([&](const Place& at) {
                    return cc_e / cubed(at) - Ball(3) * (at.cosine * wave(at)) / fourth(at);
                  }),
                  force([&](const Place& at) { return (at.cosine + cc_a) / cubed(at); }),
                  force([&](const Place& at) { return (Ball(2) * at.sine + cc_b) / cubed(at); })};
    slopes.by_b.tangential = slopes.by_b.tangential + ends.tangential;
    return slopes;
  }

 private:
  template <class Function>
  Ball constant_integral(const Function& f) const {
    return over(epsilon_, window_, f);
  }
  template <class Function>
  PolarBalls force(const Function& f) const {
    const bool step = law_ == Law::long_half_eq5;
    return {-6 * over(epsilon_, film_, [&](const Place& at) { return at.sine * f(at); }),
            6 * over(epsilon_, film_,
                     [&](const Place& at) { return (step ? at.cosine + ComplexBall(Ball(1)) : at.cosine) * f(at); })};
  }

  Law law_;
  const Ball& epsilon_;
  ExtentBalls film_;
  ExtentBalls window_;
};

/// Of all long films on 0…π at b = 0.
CoefficientBalls long_coefficients(const Ball& e, const Ball& crr, const Ball& ctr) {
  const Ball q = (Ball(1) - e) * (Ball(1) + e);
  const Ball root = sqrt(q);
  const Ball d = Ball(2) + e * e;
  const Ball pi = ball_pi();
  return {24 * e * (Ball(2) + e * e * e * e) / (d * d * q * q),
          6 * pi / (d * root),
          -6 * pi * (Ball(2) - e * e + 2 * e * e * e * e) / (d * d * q * root),
          12 * e / (d * q),
          crr,
          -24 * e / (d * q),
          ctr,
          12 * pi / (d * root)};
}

}  // namespace

CoefficientBalls coefficients(Law law, const Ball& e) {
  const Ball q = (Ball(1) - e) * (Ball(1) + e);
  const Ball root = sqrt(q);
  const Ball q_32 = q * root;
  const Ball d = Ball(2) + e * e;
  const Ball pi = ball_pi();
  const Ball growth = pi * (Ball(1) + 2 * e * e) / (q * q_32);
  const Ball zero(0);
  switch (law) {
    case Law::short_full:
      return {zero, pi / (2 * q_32), -(growth / 2), zero, growth, zero, zero, pi / q_32};
    case Law::short_half:
    case Law::short_dynamic: {
      const Ball cross = -2 * e / (q * q);
      return {2 * e * (Ball(1) + e * e) / (q * q * q),
              pi / (4 * q_32),
              -(growth / 4),
              e / (q * q),
              growth / 2,
              cross,
              cross,
              pi / (2 * q_32)};
    }
    case Law::long_full:
      return {zero, 12 * pi / (d * root), -12 * pi * (Ball(2) - e * e + 2 * e * e * e * e) / (d * d * q_32),
              zero, 12 * pi / q_32,       zero,
              zero, 24 * pi / (d * root)};
    case Law::long_half:
      return long_coefficients(e, 6 * (pi - 16 / (pi * d)) / q_32, -24 * e / (d * q));
    case Law::long_half_eq5:
      return long_coefficients(e, 6 * pi / q_32, -24 / ((Ball(1) + e) * q));
    case Law::long_dynamic:
      return long_coefficients(e, 6 * (pi - 16 * e * e / (pi * d * d)) / q_32,
                               -48 * e * (Ball(1) + e * e) / (d * d * q));
    case Law::pinkus_sternlicht:
      return long_coefficients(e, 6 * pi / q_32, -18 * pi * e / (d * q));
    case Law::squeeze_long_full:
    case Law::squeeze_short_full:
    case Law::squeeze_long:
    case Law::squeeze_short:
      break;
  }
  throw std::invalid_argument("a film of the squeeze alone has no steady state");
}

CoefficientBalls coefficients_by_quadrature(Law law, const Ball& epsilon) {
  const LawEntry& entry = laws[static_cast<std::size_t>(law)];
  if (!entry.has_pressure) throw std::invalid_argument(std::string(entry.name) + " is the integral of no pressure");
  const ExtentBalls film{Ball(0), entry.extent == Extent::full ? 2 * ball_pi() : ball_pi()};
  const Slopes slopes = entry.is_short ? short_slopes(epsilon, film) : LongSlopes(law, epsilon, film)();
  return slopes.coefficients(epsilon);
}

namespace {

/// At an ε that may itself be enclosed; that of the state is not read.
SteadyBalls steady_state_at(const LawEntry& law, const SteadyState& state, const Ball& e) {
  const Ball spin = abs(Ball(state.omega));
  const int sign = state.omega < 0 ? -1 : 1;
  const PolarBalls f = force_ratio(law.law, {e, sign * e, Ball(0)});
  const Ball size = sqrt(f.radial * f.radial + f.tangential * f.tangential);
  const Ball scale = force_scale(law, state.viscosity, state.length, state.radius, Ball(state.clearance));
  CoefficientBalls m = coefficients(law.law, e);
  const Ball trace = m.crr + m.ctt;
  const Ball kappa = (m.krr * m.ctt + m.ktt * m.crr - m.krt * m.ctr - m.ktr * m.crt) / trace;
  const Ball whirl = ((m.krr - kappa) * (m.ktt - kappa) - m.krt * m.ktr) / (m.crr * m.ctt - m.crt * m.ctr);
  for (Ball* mirrored : {&m.krt, &m.ktr, &m.crt, &m.ctr}) *mirrored = sign * *mirrored;
  // x = (along, across) in (r, t), y = (−across, along).
  const Ball along = -(f.radial / size);
  const Ball across = -(f.tangential / size);
  struct Turned {
    Ball xx, xy, yx, yy;
  };
  const auto turned = [&](const Ball& unit, const Ball& rr, const Ball& rt, const Ball& tr, const Ball& tt) {
    const Ball product = along * across;
    const Ball ll = along * along;
    const Ball cc = across * across;
    return Turned{unit * (ll * rr + product * (rt + tr) + cc * tt), unit * (ll * rt - cc * tr + product * (tt - rr)),
                  unit * (ll * tr - cc * rt + product * (tt - rr)), unit * (cc * rr - product * (rt + tr) + ll * tt)};
  };
  const Ball c_unit = scale / Ball(state.clearance);
  const Ball k_unit = c_unit * spin;
  const Turned k = turned(k_unit, m.krr, m.krt, m.ktr, m.ktt);
  const Turned c = turned(c_unit, m.crr, m.crt, m.ctr, m.ctt);
  return {scale * spin * size,
          atan2(sign * f.tangential, -f.radial),
          k.xx,
          k.xy,
          k.yx,
          k.yy,
          c.xx,
          c.xy,
          c.yx,
          c.yy,
          kappa,
          whirl,
          kappa / whirl * (c_unit / spin)};
}

}  // namespace

SteadyBalls steady_state(const LawEntry& law, const SteadyState& state) {
  return steady_state_at(law, state, Ball(state.epsilon));
}

Ball loaded_ratio(const LawEntry& law, const LoadedJournal& j) {
  return equilibrium(law, {j.viscosity, j.length, j.radius, j.clearance, j.omega, 0, -j.load}).eccentricity_ratio;
}

SteadyBalls loaded_state(const LawEntry& law, const LoadedJournal& j, const Ball& epsilon) {
  SteadyBalls b = steady_state_at(law, {j.viscosity, j.length, j.radius, j.clearance, 0, j.omega}, epsilon);
  const auto turn = [](Ball& xx, Ball& xy, Ball& yx, Ball& yy) {
    std::swap(xx, yy);
    std::swap(xy, yx);
    xy = -xy;
    yx = -yx;
  };
  turn(b.kxx, b.kxy, b.kyx, b.kyy);
  turn(b.cxx, b.cxy, b.cyx, b.cyy);
  return b;
}

}  // namespace lubjoint::certified
