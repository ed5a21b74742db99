#!/bin/sh
# What Doxygen reads in place of a header: the comment on its first line belongs to the file, and the plain comments of
# the C header are documentation. Line numbers stay.
case $1 in
*.h) sed -e 's|^/\* |/** |' -e 's|^\( *[^ /].*;\) */\* |\1 /**< |' -- "$1" ;;
*) sed -e '1s|^///|/// @file\n///|' -e '/^#pragma once$/d' -- "$1" ;;
esac
