/// Where the data that ship with the program lie: scenes, golden data, literature.
#pragma once

#include <filesystem>

namespace lubjoint::reports {

/// Folder with scenes/, golden/, literature/: share/lubjoint beside the running program's folder (/usr/bin/lubjoint
/// reads /usr/share/lubjoint, an unpacked package its own), or inside of it (the build folder, a link to data/). What
/// is not there is left to whoever opens a file in it.
/// @throws std::filesystem::filesystem_error if the system does not say where the program is
std::filesystem::path data_folder();

}  // namespace lubjoint::reports
