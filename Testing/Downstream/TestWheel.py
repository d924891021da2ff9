# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestWheel.py <source> <build>: pip builds an archive of the source tree and installs it into
a virtual environment, with no network; build options come by CMAKE_ARGS, VTK by PYTHONPATH."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import venv
import zipfile

CHECK = """
import pathlib, sys
import numpy, orthogonalslices
from orthogonalslices import reconstruct
assert pathlib.Path(orthogonalslices.__file__).is_relative_to(sys.prefix), orthogonalslices.__file__
angles = numpy.arange(60) * numpy.pi / 30
circle = lambda z, r: numpy.stack((r * numpy.cos(angles), r * numpy.sin(angles), 0 * angles + z), 1)
points, triangles, report = reconstruct(z=[circle(z, 3 - z) for z in (0, 1, 2)])
assert len(triangles) > 100 and report.fields["NumberOfComponents"] == 1
print(orthogonalslices.__version__)
"""


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, **options)


def main(source, build):
    shutil.rmtree(build, ignore_errors=True)  # of an archive unpacked elsewhere
    with tempfile.TemporaryDirectory() as scratch:
        environment = pathlib.Path(scratch, "environment")
        # Debian's NumPy is seen, and pip must not look for another one.
        venv.create(environment, system_site_packages=True, with_pip=True)
        python = environment / "bin" / "python"
        os.environ.update(PIP_NO_INDEX="1", PIP_NO_CACHE_DIR="1", PYTHONDONTWRITEBYTECODE="1",
                          PIP_DISABLE_PIP_VERSION_CHECK="1",
                          ORTHOGONAL_SLICES_WHEEL_BUILD=build)
        # By way of a source archive, so that it is known to be complete.
        sys.path.insert(0, os.path.join(source, "Filters", "Python"))
        import wheel_backend
        archive = pathlib.Path(scratch, wheel_backend.build_sdist(scratch))
        run(python, "-m", "pip", "wheel", archive, "--no-deps", "-w", scratch)
        wheel, = pathlib.Path(scratch).glob("*.whl")
        names = zipfile.ZipFile(wheel).namelist()
        libraries = [name for name in names if ".so" in name]
        assert len(libraries) == 2, f"libraries in the wheel: {libraries}"
        assert all(name.endswith(".so") for name in libraries), libraries
        assert any(name.endswith("dist-info/LICENSE") for name in names), "no licence in the wheel"
        run(python, "-m", "pip", "install", wheel)
        # Not beside the source tree, which has folders of the same name.
        version = run(python, "-c", CHECK, cwd=scratch, stdout=subprocess.PIPE, text=True).stdout
        listed = run(python, "-m", "pip", "list", stdout=subprocess.PIPE, text=True).stdout.split()
        assert listed[listed.index("orthogonalslices") + 1] == version.strip(), listed
        run(python, "-m", "pip", "uninstall", "-y", "orthogonalslices")
        assert not list(environment.rglob("*orthogonalslices*")), "pip leaves files behind"
    print(f"{wheel.name}: {', '.join(sorted(names))}")


main(*map(os.path.abspath, sys.argv[1:3]))
