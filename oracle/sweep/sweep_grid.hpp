/// The scenes of a sweep: every combination of the values that some keys of a scene take.
#pragma once

#include <string>
#include <vector>

#include "lubjoint/scene/scene_file.hpp"

namespace lubjoint::reports {

/// A key and its values, in order.
struct SweptKey {
  std::string key;
  std::vector<SceneValue> values;
};

/// Reads KEY=LO:HI:N (N values at equal distances, both ends among them), KEY=log:LO:HI:N (at equal ratios) or
/// KEY=A,B,... (numbers, true, false, or texts). Both ends are exact; those between have 15 digits.
/// @throws std::invalid_argument that names --vary, what was given and what is allowed
SweptKey parse_swept_key(const std::string& text);

/// Reads LO:HI:N or log:LO:HI:N, as above.
/// @param option  that it is the value of, for messages
/// @throws std::invalid_argument that names the option, what was given and what is allowed
std::vector<double> parse_range(const std::string& option, const std::string& text);

/// A number as it is read back, or the text itself.
std::string shown(const SceneValue& value);

/// Points are numbered from 0. The keys are in alphabetical order, whatever order they were given in; the last one
/// varies fastest.
class SweepGrid {
 public:
  /// @param keys  with numbers in place of names
  /// @throws std::invalid_argument  no key, a key twice, a key that is a name, or more than a million points
  explicit SweepGrid(std::vector<SweptKey> keys);

  const std::vector<SweptKey>& keys() const { return keys_; }
  std::size_t size() const { return size_; }
  std::vector<SceneChange> point(std::size_t index) const;
  /// "point 3 (joints[0].clearance = 0.0002, joints[0].viscosity = 0.4)"
  std::string name(std::size_t index) const;

 private:
  std::vector<SweptKey> keys_;
  std::size_t size_ = 1;
};

}  // namespace lubjoint::reports
