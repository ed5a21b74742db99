"""Build backend: setuptools, with the two shared libraries built by CMake beforehand, and the golden data.

LUBJOINT_BUILT names a folder in which CMake has built them already.
"""

import os
import pathlib
import shutil
import subprocess
import sysconfig
import tempfile

from setuptools import build_meta
from setuptools.build_meta import build_sdist, get_requires_for_build_sdist, prepare_metadata_for_build_wheel  # noqa: F401

_source = pathlib.Path(__file__).resolve().parents[2]
_package = pathlib.Path(__file__).resolve().parent / "lubjoint"
_targets = ["lubjoint_c", "lubjoint_verify_c"]


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
            for target in _targets:
                found = list(pathlib.Path(folder).rglob(f"lib{target}.so"))
                if len(found) != 1:
                    raise FileNotFoundError(f"{len(found)} files lib{target}.so below {folder}; required is one")
                copies.append(_package / found[0].name)
                shutil.copy(found[0], copies[-1])
            for table in (_source / "data" / "golden").glob("*.csv"):
                copies.append(_package / "golden" / table.name)
                copies[-1].parent.mkdir(exist_ok=True)
                shutil.copy(table, copies[-1])
            platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
            settings = {"--build-option": [f"--plat-name={platform}"]}  # shared libraries run on one platform only
            return build_meta.build_wheel(wheel_directory, settings, metadata_directory)
        finally:
            for copy in copies:
                copy.unlink(missing_ok=True)
            if (_package / "golden").exists():
                (_package / "golden").rmdir()
