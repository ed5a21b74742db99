#!/bin/sh
# What Doxygen reads in place of a header. The comment on its first line belongs to the file; formulas, which are indented
# by two, keep their lines; the plain comments of the C header are documentation. Line numbers stay.
case $1 in
*.h) sed -e 's|^/\* |/** |' -e 's|^\( *[^ /].*;\) */\* |\1 /**< |' -- "$1" ;;
*)
  sed -e '1s|^///|/// @file\n///|' -e '/^#pragma once$/d' -- "$1" | awk '
    { formula = $0 ~ /^ *\/\/\/   [^ ]/ }
    formula && !before { sub(/\/\/\/   /, "/// <pre>  ") }
    NR > 1 { print held (before && !formula ? "</pre>" : "") }
    { held = $0; before = formula }
    END { print held (before ? "</pre>" : "") }'
  ;;
esac
