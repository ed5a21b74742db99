/// The onset of a film of finite length by its name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "oracle/reynolds/finite_length.hpp"

namespace lubjoint::oracle {

/// In the order of FilmOnset.
inline constexpr std::array<std::string_view, 2> film_onset_names = {"free", "maximum_film"};

std::string_view name_of(FilmOnset onset);

/// The onset of that name; free where none is given.
/// @param film  name of any film: only finite_reynolds has an onset to choose
/// @param what  how it is called in messages: "--onset"
/// @throws std::invalid_argument  another name, or a film for which it does nothing
FilmOnset film_onset_of(std::string_view film, const std::optional<std::string>& given, const std::string& what);

}  // namespace lubjoint::oracle
