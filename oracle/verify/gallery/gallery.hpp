/// Mistakes that people make when they program a lubricated joint, each as a change of the correct work.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "oracle/verify/states/solution.hpp"

namespace lubjoint::verify {

/// One mistake. What it does to an answer is known exactly, so that an answer can be recognised by it.
struct Mistake {
  std::string_view name;
  std::string_view description;  ///< what was done
  std::string_view symptom;      ///< how it shows
  bool (*applies)(Quantities, Law);
  std::vector<Change> changes;
};

/// All mistakes, in the order in which they are described.
const std::vector<Mistake>& gallery();

/// The ones that can be made with these quantities and this law, and that change an answer. Worked out once.
const std::vector<const Mistake*>& mistakes_for(Quantities quantities, Law law);

/// The mistake of that name. @throws std::invalid_argument that lists what there is
const Mistake& mistake_of(std::string_view name);

/// What all these mistakes change, in their order.
std::vector<Change> changes_of(const std::vector<const Mistake*>& mistakes);

/// The answer of a program that makes all these mistakes; those of one step in the gallery's order.
Solution solve_with(Quantities quantities, Law law, const State& state, const std::vector<const Mistake*>& mistakes);

/// The gallery for people: a list, or a table in Markdown.
std::string described_gallery();
std::string gallery_markdown();

// Where a mistake applies, for more than one topic.
inline bool in_all(Quantities, Law) { return true; }
inline bool in_plane(Quantities q, Law) { return !is_polar(q); }
inline bool in_half_films(Quantities, Law law) { return is_half(law); }
/// Whose terms are those of a formula.
inline bool in_half_formulas(Quantities, Law law) { return is_half(law) && !is_solved_film(law); }

// The gallery by topic, one file each.
std::vector<Mistake> motion_mistakes();
std::vector<Mistake> unit_and_geometry_mistakes();
std::vector<Mistake> film_mistakes();
std::vector<Mistake> assembly_mistakes();
std::vector<Mistake> contact_mistakes();
std::vector<Mistake> rest_mistakes();
std::vector<Mistake> loss_mistakes();
std::vector<Mistake> length_mistakes();

}  // namespace lubjoint::verify
