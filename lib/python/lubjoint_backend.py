"""Build backend: setuptools, with the shared libraries built by CMake beforehand, the golden data, and the tables of films that ship.

LUBJOINT_BUILT names a folder in which CMake has built them already.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sysconfig
import tempfile

from setuptools import build_meta
from setuptools.build_meta import build_sdist, get_requires_for_build_sdist, prepare_metadata_for_build_wheel  # noqa: F401

_source = pathlib.Path(__file__).resolve().parents[2]
_package = pathlib.Path(__file__).resolve().parent / "lubjoint"
_header = (_source / "lib/include/lubjoint/version.hpp").read_text()
_number = r"^#define LUBJOINT_VERSION_{} (\d+)$"
version = ".".join(re.search(_number.format(part), _header, re.MULTILINE)[1] for part in ("MAJOR", "MINOR", "PATCH"))
_targets = {"lubjoint_c": "lib", "lubjoint_verify_c": "oracle/verify", "lubjoint_oracle_c": "oracle/c",
            "lubjoint_simulate_c": "oracle/c"}  # and where CMake leaves them

_data = {"golden": "*.csv", "films": "*.txt"}


def get_requires_for_build_wheel(config_settings=None):
    return []


def _build(folder):
    subprocess.run(["cmake", "-S", _source, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DLUBJOINT_TESTS=OFF"],
                   check=True)
    subprocess.run(["cmake", "--build", folder, "--target", *_targets], check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as temporary:
        folder = os.environ.get("LUBJOINT_BUILT")
        if folder is None:
            folder = temporary
            _build(folder)
        copies = []
        try:
            for target, place in _targets.items():
                library = pathlib.Path(folder) / place / f"lib{target}.so"
                copies.append(_package / library.name)
                shutil.copy(library, copies[-1])
            for folder, kind in _data.items():
                for table in (_source / "data" / folder).glob(kind):
                    copies.append(_package / folder / table.name)
                    copies[-1].parent.mkdir(exist_ok=True)
                    shutil.copy(table, copies[-1])
            platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
            settings = {"--build-option": [f"--plat-name={platform}"]}  # shared libraries run on one platform only
            return build_meta.build_wheel(wheel_directory, settings, metadata_directory)
        finally:
            for copy in copies:
                copy.unlink(missing_ok=True)
            for folder in _data:
                if (_package / folder).exists():
                    (_package / folder).rmdir()
