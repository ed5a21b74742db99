#!/bin/sh
# Installs the Python package as the README says, into a new environment, and uses it.
#   python_package.sh SOURCE BUILD    SOURCE: the checkout; BUILD: where CMake has built the shared libraries
set -eu
source=$1
export LUBJOINT_BUILT=$2
python=/usr/bin/python3 # Debian's, for which its python3-numpy is
if ! "$python" -c 'import numpy, setuptools, venv, ensurepip, wheel' 2>/dev/null; then
  echo 'skipped: python3-numpy, python3-setuptools, python3-venv and python3-wheel are not all installed'
  exit 77
fi
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
# Of a copy: setuptools leaves files in the folder that it builds from.
mkdir -p "$place/source/data"
cp -r "$source/pyproject.toml" "$source/lib" "$place/source"
cp -r "$source/data/golden" "$source/data/films" "$place/source/data"
"$python" -m venv --system-site-packages "$place/env"
(cd "$place/source" && "$place/env/bin/pip" install -q --disable-pip-version-check --no-build-isolation .)
shift 2
cd "$place"
"$place/env/bin/python" "$source/tests/examples/python_package.py" "$source/tests/examples" "$@"
