# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What pip calls to make a wheel of this source tree, by PEP 517; needs CMake and Python alone.

The wheel has the package orthogonalslices with the library of the filters in it, built with the VTK
that CMake finds. Environment variables:

    CMAKE_ARGS                    more options, as -DVTK_DIR=...
    CMAKE_BUILD_PARALLEL_LEVEL    how many compilers run at a time
    ORTHOGONAL_SLICES_WHEEL_BUILD the build folder; build/wheel otherwise
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What is needed to build the package.
SOURCES = ("CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "Filters", "LICENSE", "Plugin/Examples",
           "Plugin/Packages", "README.md", "pyproject.toml", "vtk.module")


def project():
    """The table [project] of pyproject.toml, with the version that CMakeLists.txt has."""
    table = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    table["version"] = re.search(r"^\s*VERSION\s+([\d.]+)", text, re.MULTILINE).group(1)
    return table


def metadata():
    """The text of METADATA and of PKG-INFO."""
    table = project()
    lines = ["Metadata-Version: 2.1"]
    lines += [f"{key}: {table[name]}" for key, name in (
        ("Name", "name"), ("Version", "version"), ("Summary", "description"),
        ("License", "license"), ("Requires-Python", "requires-python"))]
    lines += [f"Requires-Dist: {name}" for name in table["dependencies"]]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join(lines) + "\n" + (ROOT / table["readme"]).read_text(encoding="utf-8")


def tag():
    """Interpreter, its binary interface, and the platform."""
    interpreter = "cp{}{}".format(*sys.version_info[:2])
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{interpreter}-{interpreter}-{platform}"


def build(prefix):
    """Builds the package and installs it into the folder `prefix`."""
    folder = os.environ.get("ORTHOGONAL_SLICES_WHEEL_BUILD", ROOT / "build" / "wheel")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    run = lambda *command: subprocess.run([str(word) for word in command], check=True)
    run("cmake", *generator, "-S", ROOT, "-B", folder,
        f"-DPython3_EXECUTABLE={sys.executable}",
        "-DORTHOGONAL_SLICES_BUILD_TESTING=OFF",
        "-DORTHOGONAL_SLICES_BUILD_PLUGIN=OFF",
        "-DORTHOGONAL_SLICES_WRAP_PYTHON=ON",
        # Library and extension beside each other; a wheel has no symbolic links.
        "-DORTHOGONAL_SLICES_PYTHON_DESTINATION=.",
        "-DCMAKE_INSTALL_LIBDIR=orthogonalslices",
        "-DCMAKE_PLATFORM_NO_VERSIONED_SONAME=ON",
        # A VTK that lies elsewhere is found again.
        "-DCMAKE_INSTALL_RPATH_USE_LINK_PATH=ON",
        *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    parallel = [] if "CMAKE_BUILD_PARALLEL_LEVEL" in os.environ else ["-j", os.cpu_count() or 1]
    run("cmake", "--build", folder, *parallel)
    for component in ("python", "runtime"):
        run("cmake", "--install", folder, "--prefix", prefix, "--component", component, "--strip")


def digest(data):
    """A file's entry in RECORD."""
    text = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"sha256={text},{len(data)}"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Makes the wheel in `wheel_directory` and returns its name."""
    table = project()
    stem = f"{table['name']}-{table['version']}"
    info = f"{stem}.dist-info"
    files = {
        f"{info}/METADATA": metadata().encode(),
        f"{info}/WHEEL": ("Wheel-Version: 1.0\nGenerator: orthogonalslices\n"
                          f"Root-Is-Purelib: false\nTag: {tag()}\n").encode(),
        f"{info}/LICENSE": (ROOT / "LICENSE").read_bytes(),
    }
    with tempfile.TemporaryDirectory() as prefix:
        build(prefix)
        package = pathlib.Path(prefix, table["name"])
        files |= {path.relative_to(prefix).as_posix(): path.read_bytes()
                  for path in package.iterdir() if path.is_file()}
    record = [f"{name},{digest(data)}" for name, data in sorted(files.items())]
    files[f"{info}/RECORD"] = ("\n".join(record) + f"\n{info}/RECORD,,\n").encode()
    name = f"{stem}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path)
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Packs what is needed to build the package, and returns the archive's name."""
    table = project()
    stem = f"{table['name']}-{table['version']}"
    leave_out = lambda entry: None if "__pycache__" in entry.name else entry
    with tempfile.TemporaryDirectory() as folder:
        information = pathlib.Path(folder, "PKG-INFO")
        information.write_text(metadata(), encoding="utf-8")
        archive = pathlib.Path(sdist_directory, f"{stem}.tar.gz")
        with tarfile.open(archive, "w:gz", format=tarfile.PAX_FORMAT) as sdist:
            sdist.add(information, f"{stem}/PKG-INFO")
            for name in SOURCES:
                sdist.add(ROOT / name, f"{stem}/{name}", filter=leave_out)
    return archive.name
