/// Smooth pieces of a free journal's motion.
///
/// A law that is continuous has one. A half film jumps at a = 0, and its motion has three kinds of piece: the film on
/// one side, on the other, and sliding, where both sides push the journal back to a = 0 and the tangential force is
/// whatever keeps it there (Filippov). Every piece is integrated by itself and ends at an event; nothing is smoothed.
///
/// A mode has: dimension; coordinates, how many of its states are places whose rates are states, too; rate(y, dydt, t)
/// on any scalar (or its own jacobian(y, j)), and time_slope(t, slope), its partial derivative by the time; journal(t,
/// y), the state ê, w that it stands for; force(t, y); margins(t, y), positive while the mode lasts; and, where it may
/// be at most once differentiable at ε̇ = 0, kinks().
#pragma once

#include <array>
#include <cmath>

#include "lubjoint/motion/jump_side.hpp"
#include "lubjoint/multibody/massless_journal.hpp"

namespace lubjoint {

/// The whole motion of a continuous law.
template <class Law>
class SmoothMode {
 public:
  static constexpr std::size_t dimension = 4;     ///< number of states
  static constexpr std::size_t coordinates = 2;   ///< ê
  static constexpr std::size_t margin_count = 0;  ///< it never ends

  /// The journal as it is.
  explicit SmoothMode(const FreeJournal<Law>& journal) : journal_(journal) {}

  /// Right-hand side.
  template <class T>
  void rate(const std::array<T, 4>& y, std::array<T, 4>& dydt, double) const {
    journal_.rate(y, dydt);
  }
  void time_slope(double, std::array<double, 4>& slope) const { slope.fill(0); }  ///< time does not enter
  /// ê and w.
  JournalState<double> journal(double, const std::array<double, 4>& y) const { return y; }
  /// On the journal [N].
  Vector2<double> force(double, const std::array<double, 4>& y) const { return journal_.force(y); }
  std::array<double, 0> margins(double, const std::array<double, 4>&) const { return {}; }  ///< none
  bool kinks() const { return journal_.joint().kinks(); }  ///< where ε̇ changes sign?

 private:
  const FreeJournal<Law>& journal_;
};

/// The whole motion of a journal without mass: ê alone.
template <class Law>
class MasslessMode {
 public:
  static constexpr std::size_t dimension = 2;     ///< number of states
  static constexpr std::size_t coordinates = 0;   ///< their rates are no states
  static constexpr std::size_t margin_count = 0;  ///< it never ends

  /// The journal as it is.
  explicit MasslessMode(const MasslessJournal<Law>& journal) : journal_(journal) {}

  /// Right-hand side.
  void rate(const std::array<double, 2>& y, std::array<double, 2>& dydt, double) const { journal_.rate(y, dydt); }
  /// Its derivative.
  template <class Matrix>
  void jacobian(const std::array<double, 2>& y, Matrix& j) const {
    j = journal_.jacobian(y);
  }
  void time_slope(double, std::array<double, 2>& slope) const { slope.fill(0); }  ///< time does not enter
  /// ê and w.
  JournalState<double> journal(double, const std::array<double, 2>& y) const {
    std::array<double, 2> w{};
    journal_.rate(y, w);
    return {y[0], y[1], w[0], w[1]};
  }
  /// On the journal [N]: what carries the load.
  Vector2<double> force(double, const std::array<double, 2>&) const { return -journal_.drive().load; }
  std::array<double, 0> margins(double, const std::array<double, 2>&) const { return {}; }  ///< none
  bool kinks() const { return journal_.joint().kinks(); }  ///< where ε̇ changes sign?

 private:
  const MasslessJournal<Law>& journal_;
};

/// Half film on a given side, continued smoothly beyond a = 0; ends where a changes sign.
template <JumpingLaw Law>
class SidedMode {
 public:
  static constexpr std::size_t dimension = 4;     ///< number of states
  static constexpr std::size_t coordinates = 2;   ///< ê
  static constexpr std::size_t margin_count = 1;  ///< sign of a

  /// The journal, its film on the given side.
  /// @param from_jump  does the side begin on a = 0?
  SidedMode(const FreeJournal<Law>& journal, HalfFilmSide side, bool from_jump)
      : journal_(journal), side_(side), from_jump_(from_jump) {}

  /// Right-hand side.
  template <class T>
  void rate(const std::array<T, 4>& y, std::array<T, 4>& dydt, double) const {
    journal_.rate(y, dydt, side_);
  }
  void time_slope(double, std::array<double, 4>& slope) const { slope.fill(0); }  ///< time does not enter
  /// ê and w.
  JournalState<double> journal(double, const std::array<double, 4>& y) const { return y; }
  /// On the journal [N].
  Vector2<double> force(double, const std::array<double, 4>& y) const {
    return journal_.joint().force(journal_.film(y), side_);
  }
  /// −(ê × u)/(|ê||u|) on the converging side, where a > 0: the sine of the angle between ê and u.
  std::array<double, 1> margins(double, const std::array<double, 4>& y) const {
    const FilmState<double> film = journal_.film(y);
    if (is_zero(film.eccentricity) || is_zero(film.velocity)) return {0.0};
    const double sine = cross(direction(film.eccentricity), direction(film.velocity));
    return {side_ == HalfFilmSide::converging ? -sine : sine};
  }

  /// It begins on a = 0 and may part from it slowly, by less than the errors of the run.
  bool begins_unparted() const { return from_jump_; }
  /// What that margin may be below 0 before the side is wrong beyond any error.
  double wrong_side(const std::array<double, 4>& y) const {
    return lubjoint::wrong_side(journal_.film(y).velocity.norm(), std::abs(journal_.drive().mean_spin()));
  }

 private:
  const FreeJournal<Law>& journal_;
  HalfFilmSide side_;
  bool from_jump_;
};

/// Sliding on a = 0. There u is parallel to ê, so the line of centres turns with the mean spin ω̄ = ½(ω_J + ω_B):
///   e = c ρ n(t),  n(t) at the angle γ₀ + ω̄(t − t₀),  ρ̈ = ω̄²ρ + (F + W)·n/(m c),
/// two states ρ and β = ρ̇ in place of four. Staying on a = 0 takes the tangential force Φ = 2 m c ω̄ β − W·n⊥; the
/// film can give anything in [−X, X], X its tangential force on the converging side. It ends where |Φ| exceeds X.
template <JumpingLaw Law>
class SlidingMode {
 public:
  static constexpr std::size_t dimension = 2;     ///< number of states
  static constexpr std::size_t coordinates = 1;   ///< ρ
  static constexpr std::size_t margin_count = 2;  ///< X − Φ and X + Φ

  /// @param t_start  t₀
  /// @param line  n(t₀), a unit vector
  SlidingMode(const FreeJournal<Law>& journal, double t_start, const Vector2<double>& line)
      : journal_(journal), t_start_(t_start), line_(line) {}

  /// Right-hand side.
  template <class T>
  void rate(const std::array<T, 2>& y, std::array<T, 2>& dydt, double t) const {
    const double spin = journal_.drive().mean_spin();
    const T film = on_jump(y).along;
    const double load = dot(journal_.drive().load, line_at(t));
    dydt[0] = y[1];
    dydt[1] = spin * spin * y[0] + (film + load) / journal_.inertia();
  }

  /// The load turns in the frame of the line.
  void time_slope(double t, std::array<double, 2>& slope) const {
    const JournalDrive<double>& drive = journal_.drive();
    slope = {0, drive.mean_spin() * dot(drive.load, perpendicular(line_at(t))) / journal_.inertia()};
  }

  /// ê and w.
  JournalState<double> journal(double t, const std::array<double, 2>& y) const {
    const Vector2<double> n = line_at(t);
    const double across = journal_.drive().mean_spin() * y[0];
    return {y[0] * n.x(), y[0] * n.y(), y[1] * n.x() - across * n.y(), y[1] * n.y() + across * n.x()};
  }

  /// On the journal [N].
  Vector2<double> force(double t, const std::array<double, 2>& y) const {
    const Vector2<double> n = line_at(t);
    return Vector2<double>(on_jump(y).along * n + tangential_force(t, y) * perpendicular(n));
  }

  /// Φ, the tangential force that keeps a = 0 [N].
  double tangential_force(double t, const std::array<double, 2>& y) const {
    const JournalDrive<double>& drive = journal_.drive();
    return 2 * journal_.inertia() * drive.mean_spin() * y[1] - dot(drive.load, perpendicular(line_at(t)));
  }

  /// X, the half film's tangential force on the converging side of a = 0 [N], along n⊥.
  double tangential_reach(const std::array<double, 2>& y) const { return on_jump(y).reach; }

  /// X − Φ and X + Φ, over the load that the drive puts on the journal.
  std::array<double, 2> margins(double t, const std::array<double, 2>& y) const {
    const double reach = tangential_reach(y);
    const double needed = tangential_force(t, y);
    return {reach - needed, reach + needed};
  }

  /// n(t).
  Vector2<double> line_at(double t) const {
    const double angle = journal_.drive().mean_spin() * (t - t_start_);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return Vector2<double>(c * line_.x() - s * line_.y(), s * line_.x() + c * line_.y());
  }

 private:
  template <class T>
  JumpForce<T> on_jump(const std::array<T, 2>& y) const {
    return journal_.joint().on_jump(y[0], y[1]);
  }

  const FreeJournal<Law>& journal_;
  double t_start_;
  Vector2<double> line_;
};

}  // namespace lubjoint
