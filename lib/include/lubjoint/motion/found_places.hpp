/// Places that were found of late, of bodies in coordinates that their constraints leave free.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace lubjoint {

/// Those of the times of a step's stages and of its start, which are asked for again and again, and one to search in.
/// @tparam In  InPlane or InSpace;  @tparam Columns  so many columns of V at a velocity
template <class In, class Columns>
class FoundPlaces {
  using R = typename In::R;

 public:
  /// What a time prescribes.
  struct Moment {
    std::vector<R> rates;                                ///< the prescribed velocities, in their order
    std::vector<R> accelerations;                        ///< likewise
    std::vector<typename In::template Frame<R>> frames;  ///< of their bodies
    std::vector<R> numbers;                              ///< of their rows, and their factors
  };
  /// Places that were found at a time.
  struct Place {
    R t{};                                               ///< the time [s]
    bool known = false;                                  ///< was anything found?
    std::size_t number = 0;                              ///< counts places of new times
    std::size_t moment = 0;                              ///< that of its time
    std::vector<R> q;                                    ///< of all bodies
    std::vector<R> z;                                    ///< the chart's functions there
    std::vector<Columns> columns;                        ///< V and d of the free velocities, in their order
    std::vector<typename In::Orientation> orientations;  ///< of bodies with a free velocity
    std::vector<R> numbers;                              ///< of the free rows, and their factors
  };

  /// @param freedoms  functions of the chart
  FoundPlaces(std::size_t bodies, std::size_t freedoms) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      places_[i].q.resize(In::coordinates * bodies);
      places_[i].z.resize(freedoms);
      places_[i].orientations.resize(bodies);
      places_[i].moment = i;
    }
  }

  /// Takes the memory that the parts of a chart need, with so many groups of columns.
  template <class Part>
  void resize(const Part& prescribed, const Part& free, std::size_t groups) {
    for (Moment& each : moments_) {
      each.rates.assign(prescribed.size(), R(0));
      each.accelerations.assign(prescribed.size(), R(0));
      each.frames.assign(prescribed.bodies.size(), In::ground());
      each.numbers.assign(prescribed.lu.storage(), R(0));
    }
    for (Place& each : places_) {
      each.columns.assign(free.size() * groups, Columns::Zero());
      each.numbers.assign(free.lu.storage(), R(0));
    }
  }

  /// None is known.
  void forget() {
    for (Place& each : places_) each.known = false;
  }

  const Place& latest() const { return places_[latest_]; }                              ///< that of the last search
  Place& latest() { return places_[latest_]; }                                          ///< likewise
  const Moment& moment_of(const Place& place) const { return moments_[place.moment]; }  ///< of a place's time
  Moment& moment_of(const Place& place) { return moments_[place.moment]; }              ///< likewise

  /// The one that is known at a time, or nullptr.
  Place* at(const R& t) {
    for (Place& each : places_) {
      if (each.known && each.t == t) return &each;
    }
    return nullptr;
  }

  Place& spare() { return places_[spare_]; }  ///< to search in

  /// The spare place is that of a time from now on, in place of the one that was known, or of the oldest.
  void take_spare(const R& t, Place* earlier) {
    Place& found = places_[spare_];
    found.t = t;
    found.known = true;
    latest_ = spare_;
    if (earlier != nullptr) {
      found.number = earlier->number;
      std::swap(found.moment, earlier->moment);
      spare_ = static_cast<std::size_t>(earlier - places_.data());
    } else {
      found.number = ++counted_;
      spare_ = 0;
      for (std::size_t i = 1; i < places_.size(); ++i) {
        if (places_[i].number < places_[spare_].number) spare_ = i;
      }
    }
    places_[spare_].known = false;
  }

 private:
  /// Five stages at most, the start, and one to search in.
  static constexpr std::size_t kept = 7;

  std::array<Place, kept> places_;
  std::array<Moment, kept> moments_;
  std::size_t latest_ = 0;
  std::size_t spare_ = 1;
  std::size_t counted_ = 0;
};

}  // namespace lubjoint
