/// A film whose law is chosen when the program runs.
///
/// The laws of law_list.hpp, and finite_half, which jumps, are types in everything that a run is made of. The others
/// share what is compiled for this one film, at the price of a call through a pointer for each force and, for
/// derivatives, of a product with the film's own Jacobian.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "lubjoint/film/compiled_laws.hpp"
#include "lubjoint/film/compiled_mobility.hpp"
#include "lubjoint/film/shaped_mobility.hpp"
#include "lubjoint/joint/lubricated_joint.hpp"

namespace lubjoint {

/// Does a law answer every force with one velocity? Half films answer some with two and some with none, squeeze-only
/// laws with a line of them or with none, and Butenschön's sum, which is not passive, with any number: they leave the
/// motion of a journal without mass open.
template <class Law>
inline constexpr bool moves_massless_journal =
    is_law_of<Law, FilmLaws> || CompiledLaw<Law> ? Law::extent != FilmExtent::half : std::is_same_v<Law, MoesImpedance>;

/// What a law of finite length asks of a bearing, and the law itself where it is compiled.
template <class R>
struct FilmShape {
  R length_to_diameter;            ///< L/D
  const AnyCompiledLaw* compiled;  ///< null but for a compiled law
};

/// F/S of a law at a state, and its derivatives by ê_x, ê_y, u_x, u_y, with q = 1 − ê·ê.
template <class R>
struct FilmSlopes {
  Vector2<R> ratio;                 ///< F/S [1/s]
  Eigen::Matrix<R, 2, 4> by_state;  ///< rows: x and y of F/S
};

/// What one law does with numbers of one kind.
template <class R>
struct FilmFunctions {
  std::string_view law;  ///< its name
  BearingLimit limit;    ///< its force scale
  bool kinks;            ///< is it at most once differentiable where b changes sign?
  /// F/S at a state, of a bearing of that L/D.
  Vector2<R> (*ratio)(const FilmState<R>& film, const FilmShape<R>& shape);
  /// The same with its derivatives.
  FilmSlopes<R> (*slopes)(const FilmState<R>& film, const FilmShape<R>& shape);
  /// u at which the film carries F/S at ê, q = 1 − ê·ê; null unless every force has one velocity (mobility.hpp).
  Vector2<R> (*velocity)(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force, const FilmShape<R>& shape);
};

namespace detail {

template <class Law, class T>
Vector2<T> ratio_in_bearing(const FilmState<T>& film, [[maybe_unused]] const FilmShape<RealOf<T>>& shape) {
  if constexpr (FilmLaw<Law>) {
    return force_ratio<Law>(film);
  } else if constexpr (CompiledLaw<Law>) {
    return compiled_force_ratio(*std::get_if<Law>(shape.compiled), film);
  } else {
    return shaped_force_ratio<Law>(film, shape.length_to_diameter);
  }
}

template <class Law, class R>
FilmSlopes<R> slopes_in_bearing(const FilmState<R>& film, const FilmShape<R>& shape) {
  using D = Dual<R, 4>;
  const Vector2<D> e(D::variable(film.eccentricity.x(), 0), D::variable(film.eccentricity.y(), 1));
  const Vector2<D> u(D::variable(film.velocity.x(), 2), D::variable(film.velocity.y(), 3));
  D q(film.q);
  q.derivatives()(0) = -2 * film.eccentricity.x();
  q.derivatives()(1) = -2 * film.eccentricity.y();
  const Vector2<D> ratio = ratio_in_bearing<Law>(FilmState<D>(e, u, q, Unchecked()), shape);
  FilmSlopes<R> result{Vector2<R>(ratio.x().value(), ratio.y().value()), {}};
  for (Eigen::Index i = 0; i < 2; ++i) result.by_state.row(i) = ratio(i).derivatives().transpose();
  return result;
}

template <class Law, class R>
Vector2<R> velocity_in_bearing(const Vector2<R>& e_hat, const R& q, const Vector2<R>& force,
                               [[maybe_unused]] const FilmShape<R>& shape) {
  if constexpr (FilmLaw<Law>) {
    return *mobility<Law>(e_hat, q, force).velocity;
  } else if constexpr (CompiledLaw<Law>) {
    return *compiled_mobility(*std::get_if<Law>(shape.compiled), e_hat, q, force).velocity;
  } else {
    return moes_velocity(e_hat, q, force, shape.length_to_diameter);
  }
}

template <class Law, class R>
constexpr FilmFunctions<R> functions_of_law() {
  FilmFunctions<R> functions{
      Law::name, Law::limit, KinkedLaw<Law>, &ratio_in_bearing<Law, R>, &slopes_in_bearing<Law, R>, nullptr};
  if constexpr (moves_massless_journal<Law>) functions.velocity = &velocity_in_bearing<Law, R>;
  return functions;
}

}  // namespace detail

/// The functions of the law of that name.
/// @throws std::invalid_argument that lists the laws there are
template <class R>
const FilmFunctions<R>& film_functions(std::string_view law) {
  static constexpr auto all = []<class... Law>(std::type_identity<std::tuple<Law...>>) {
    return std::array<FilmFunctions<R>, sizeof...(Law)>{detail::functions_of_law<Law, R>()...};
  }(std::type_identity<NamedFilmLaws>{});
  return all[film_law_index<NamedFilmLaws>(law)];
}

/// The table of a compiled law's film. @throws std::invalid_argument that says who is to give it, if it is null
template <CompiledLaw Law>
const CompiledFilm& table_of(const CompiledFilm* table) {
  if (table != nullptr) return *table;
  throw std::invalid_argument(
      "the law " + std::string(Law::name) +
      " is a table compiled for the bearing's length over diameter, and none was given; allowed "
      "is a CompiledFilm, read by read_compiled_film from a file of lubjoint compile-film");
}

/// In place of a law's type: the film is a ChosenFilm.
struct ChosenLaw {};

/// A bearing, an oil, and the law of that name: what LubricatedJoint is for a law that is a type.
template <class R>
class ChosenFilm {
 public:
  static constexpr bool jumps = false;  ///< a half film is a LubricatedJoint, which knows its sides

  /// @param table  of a law that is compiled; no other law asks
  /// @throws std::invalid_argument  an unknown law, a half film, a bearing that the law is not made for, a compiled law
  ///         without its table
  ChosenFilm(std::string_view law, const Bearing<R>& bearing, const Lubricant<R>& oil,
             const CompiledFilm* table = nullptr)
      : functions_(&film_functions<R>(law)),
        bearing_(bearing),
        scale_(lubjoint::force_scale(functions_->limit, bearing, oil)),
        shape_(length_to_diameter(bearing)) {
    with_film_law<NamedFilmLaws>(law, [&]<class Law>() {
      if constexpr (ShapedFilmLaw<Law>) require_shape<Law>(shape_);
      if constexpr (JumpingLaw<Law>) {
        throw std::invalid_argument(std::string(law) + " jumps; its film is a type");
      } else if constexpr (CompiledLaw<Law>) {
        compiled_ = std::make_shared<const AnyCompiledLaw>(std::in_place_type<Law>, table_of<Law>(table));
        require_shape_of(*std::get_if<Law>(compiled_.get()), bearing);
      }
    });
  }

  const Bearing<R>& bearing() const { return bearing_; }  ///< L, R, c
  const R& force_scale() const { return scale_; }         ///< S [N s]
  bool kinks() const { return functions_->kinks; }        ///< is it at most once differentiable where b changes sign?

  /// Force on the journal [N], inertial.
  /// @throws FilmDomainError where |e| ≥ c
  template <class T>
  Vector2<T> force(const FilmState<T>& film) const {
    if constexpr (ScalarTraits<T>::carries_derivatives) {
      const Vector2<T>& e = film.eccentricity;
      const Vector2<T>& u = film.velocity;
      const FilmSlopes<R> at =
          functions_->slopes(FilmState<R>(Vector2<R>(value_of(e.x()), value_of(e.y())),
                                          Vector2<R>(value_of(u.x()), value_of(u.y())), value_of(film.q), Unchecked()),
                             shape());
      const auto component = [&](Eigen::Index i) {
        const auto slope = at.by_state.row(i);
        return T(scale_ * at.ratio(i), scale_ * (slope(0) * e.x().derivatives() + slope(1) * e.y().derivatives() +
                                                 slope(2) * u.x().derivatives() + slope(3) * u.y().derivatives()));
      };
      return Vector2<T>(component(0), component(1));
    } else {
      const Vector2<R> ratio = functions_->ratio(film, shape());
      return Vector2<R>(R(scale_ * ratio.x()), R(scale_ * ratio.y()));
    }
  }

  /// Does every force have one velocity that carries it?
  bool has_velocity() const { return functions_->velocity != nullptr; }

  /// u, the pure-squeeze velocity at which the film's force on the journal is `force` [N]. Needs has_velocity.
  /// @throws FilmDomainError where |e| ≥ c
  Vector2<R> velocity(const Vector2<R>& e_hat, const Vector2<R>& force) const {
    return functions_->velocity(e_hat, one_minus_squared_norm<R>(e_hat.x(), e_hat.y()), Vector2<R>(force / scale_),
                                shape());
  }

 private:
  FilmShape<R> shape() const { return {shape_, compiled_.get()}; }

  const FilmFunctions<R>* functions_;
  Bearing<R> bearing_;
  R scale_;
  R shape_;                                         ///< L/D
  std::shared_ptr<const AnyCompiledLaw> compiled_;  ///< none but for a compiled law
};

namespace detail {
template <class Law, class R>
struct FilmOfLaw {
  using Type = LubricatedJoint<Law, R>;
};
template <class R>
struct FilmOfLaw<ChosenLaw, R> {
  using Type = ChosenFilm<R>;
};
}  // namespace detail

/// The film of a law's type, or of ChosenLaw.
template <class Law, class R>
using FilmOf = typename detail::FilmOfLaw<Law, R>::Type;

/// The type by which a law's runs are compiled: its own where it is of law_list.hpp or jumps.
template <class Law>
using RunLaw = std::conditional_t<is_law_of<Law, FilmLaws> || CompiledHalfFilmLaw<Law>, Law, ChosenLaw>;

/// The film of that name and of RunLaw's type.
/// @param table  of a law that is compiled; no other law asks
/// @throws std::invalid_argument as ChosenFilm
template <class Law, class R>
FilmOf<Law, R> film_of([[maybe_unused]] std::string_view law, const Bearing<R>& bearing, const Lubricant<R>& oil,
                       [[maybe_unused]] const CompiledFilm* table = nullptr) {
  if constexpr (std::is_same_v<Law, ChosenLaw>) {
    return ChosenFilm<R>(law, bearing, oil, table);
  } else if constexpr (CompiledLaw<Law>) {
    return LubricatedJoint<Law, R>(Law(table_of<Law>(table)), bearing, oil);
  } else {
    return LubricatedJoint<Law, R>(bearing, oil);
  }
}

}  // namespace lubjoint
