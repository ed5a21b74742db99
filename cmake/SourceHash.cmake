# Run as a script: writes OUTPUT, a C++ file whose function FUNCTION, declared in HEADER, returns the version and a
# checksum of the files listed in LIST.
file(STRINGS ${LIST} files)
list(SORT files)
set(all "")
foreach(file IN LISTS files)
  file(SHA256 ${ROOT}/${file} sum)
  string(APPEND all "${file} ${sum}\n")
endforeach()
string(SHA256 checksum "${all}")
string(SUBSTRING ${checksum} 0 12 checksum)
file(WRITE ${OUTPUT}
"#include \"${HEADER}\"

std::string lubjoint::reports::${FUNCTION}() { return \"${VERSION} ${checksum}\"; }
")
