# cmake -DFOLDER=… -DFILES="a b c" -DOUTPUT=….cpp -P Embed.cmake: files as string literals, for page/resources.hpp.
separate_arguments(FILES)
set(rows "")
foreach(file ${FILES})
  file(READ "${FOLDER}/${file}" text)
  string(APPEND rows "    {\"${file}\", R\"lubjoint_page(${text})lubjoint_page\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made by cmake/Embed.cmake.
#include <stdexcept>
#include <string>

#include \"oracle/page/resources.hpp\"

namespace lubjoint::reports::page {

std::string_view resource(std::string_view file_name) {
  struct Resource {
    std::string_view name;
    std::string_view text;
  };
  static constexpr Resource resources[] = {
${rows}  };
  for (const Resource& entry : resources) {
    if (entry.name == file_name) return entry.text;
  }
  throw std::logic_error(\"the page has no resource \" + std::string(file_name));
}

}  // namespace lubjoint::reports::page
")
