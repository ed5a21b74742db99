#include "oracle/files/data_folder.hpp"

namespace lubjoint::reports {

namespace fs = std::filesystem;

fs::path data_folder() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path inside = program / "share" / "lubjoint";
  return fs::is_directory(inside) ? fs::canonical(inside) : program.parent_path() / "share" / "lubjoint";
}

}  // namespace lubjoint::reports
