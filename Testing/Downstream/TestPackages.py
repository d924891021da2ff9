# SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 TestPackages.py <build> <Downstream> <TestMenu.xml>: makes Debian packages of a build with
ParaView, installs them into a clean root, uses them there without any path set, and removes them.

The clean root is this system with the packages on top of it, in a mount namespace: nothing of it is
seen from outside, or stays. Where mounting is not allowed, the packages are unpacked into an empty
folder beside copies of ParaView's programs; then C++, Python and the linker are told where they lie.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PACKAGES = {
    "runtime": r"libvtkfiltersorthogonalslices[\d.]+",
    "development": "libvtkfiltersorthogonalslices-dev",
    "python": "python3-orthogonalslices",
    "plugin": "paraview-orthogonalslices",
}
PROGRAMS = ("paraview", "pvpython")
PLUGINS = "usr/bin/plugins"

LISTED = """
from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
from paraview import simple
tracker = vtkPVPluginTracker.GetInstance()
names = [tracker.GetPluginName(k) for k in range(tracker.GetNumberOfPlugins())]
assert "OrthogonalSlices" in names, f"listed are {names}"
assert tracker.GetPluginLoaded(names.index("OrthogonalSlices")), "it is not loaded"
slicer = simple.OrthogonalSlicer(Input=simple.Sphere())
surface = simple.ParallelSliceReconstruction(Input=simple.OutputPort(slicer, 2))
surface.UpdatePipeline()
assert surface.GetDataInformation().GetNumberOfCells() > 0, "the surface is empty"
"""
IMPORTED = """
import pathlib, sys
import orthogonalslices
from orthogonalslices import reconstruct
from orthogonalslices.vtkFiltersOrthogonalSlices import vtkOrthogonalSlicer
place = pathlib.Path(orthogonalslices.__file__).parent
assert place.parent.name == "dist-packages" and "usr/lib/python3" in str(place), place
"""


def run(*command, **options):
    print("+", *command, flush=True)
    return subprocess.run([str(word) for word in command], check=True, **options)


def output_of(*command):
    return run(*command, stdout=subprocess.PIPE, text=True).stdout


def make_packages(build, folder):
    """The packages by component, checked for what Debian wants of each."""
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, stdout=subprocess.DEVNULL)
    files = {}
    for component, name in PACKAGES.items():
        found = [deb for deb in folder.glob("*.deb") if re.match(name + "_", deb.name)]
        assert len(found) == 1, f"packages {name}: {found}"
        files[component] = found[0]
        package = output_of("dpkg-deb", "-f", found[0], "Package").strip()
        names = output_of("dpkg-deb", "-c", found[0])
        for text in ("copyright", "changelog.gz", "changelog.Debian.gz"):
            assert f"./usr/share/doc/{package}/{text}\n" in names, f"no {text} in {package}"
    depends = {component: output_of("dpkg-deb", "-f", deb, "Depends")
               for component, deb in files.items()}
    assert "paraview (>= 5" in depends["runtime"] and "libstdc++6" in depends["runtime"], depends
    for component in ("development", "python", "plugin"):
        assert re.search(PACKAGES["runtime"] + r" \(= ", depends[component]), depends
    assert re.search(r"libvtkFiltersOrthogonalSlices\.so\.[\d.]+ ->",
                     output_of("dpkg-deb", "-c", files["runtime"])), "the library has no version"
    control = output_of("dpkg-deb", "-I", files["runtime"], "shlibs", "triggers")
    assert "libvtkFiltersOrthogonalSlices" in control and "activate-noawait ldconfig" in control
    examples = output_of("dpkg-deb", "-c", files["python"])
    assert "Examples/ReconstructAny.py" in examples and "heart/n32_x.vtp" in examples, examples
    plugin = output_of("dpkg-deb", "-c", files["plugin"])
    assert "usr/share/orthogonalslices/Macros/Inspect Slices.py" in plugin, plugin
    if shutil.which("qhelpgenerator"):
        assert "doc/orthogonalslices/Help/filters.OrthogonalSlicer.html" in plugin, plugin
    return files


class System:
    """This system with the packages installed, in a mount namespace of this process."""

    def __init__(self, scratch):
        # What is mounted from here on is seen by this process and its children alone.
        run("mount", "--make-rprivate", "/")
        run("mount", "-t", "tmpfs", "tmpfs", scratch)
        for name in ("upper", "work", "root"):
            (scratch / name).mkdir()
        self.root = scratch / "root"
        run("mount", "-t", "overlay", "overlay", "-o",
            f"lowerdir=/,upperdir={scratch}/upper,workdir={scratch}/work", self.root)
        for name in ("dev", "sys"):
            run("mount", "--rbind", f"/{name}", self.root / name)
        run("mount", "-t", "proc", "proc", self.root / "proc")
        self.options = []

    def install(self, files):
        shutil.rmtree(self.root / "packages", ignore_errors=True)
        (self.root / "packages").mkdir()
        for deb in files.values():
            shutil.copy(deb, self.root / "packages")
        self.run("sh", "-c", "dpkg -i /packages/*.deb")

    def remove(self, files):
        names = [output_of("dpkg-deb", "-f", deb, "Package").strip() for deb in files.values()]
        self.run("dpkg", "--purge", *names)
        left = [path for name in names for path in self.root.glob(f"usr/share/doc/{name}*")]
        left += self.root.glob("usr/lib/*/libvtkFiltersOrthogonalSlices*")
        left += self.root.glob("usr/lib/python3/dist-packages/orthogonalslices*")
        assert not left, f"left behind: {left}"

    def run(self, *command):
        # Settings of who runs the tests stay out, and so do paths.
        environment = {"HOME": "/home-of-tests", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
                       "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}
        run("chroot", self.root, *command, env=environment)

    def path(self, path):
        return f"/{path}"


class Folder(System):
    """An empty folder with the packages unpacked, and ParaView's programs copied beside them."""

    def __init__(self, scratch):
        self.root = scratch / "root"
        (self.root / "usr" / "bin").mkdir(parents=True)
        for program in PROGRAMS:
            shutil.copy(shutil.which(program), self.root / "usr" / "bin")
        self.options = [f"-DCMAKE_PREFIX_PATH={self.root}/usr"]

    def maintain(self, files, script, action):
        with tempfile.TemporaryDirectory() as control:
            run("dpkg-deb", "-e", files["plugin"], control)
            run(os.path.join(control, script), action,
                env={**os.environ, "DPKG_ROOT": str(self.root)})

    def install(self, files):
        for deb in files.values():
            run("dpkg-deb", "-x", deb, self.root)
        self.maintain(files, "postinst", "configure")

    def remove(self, files):
        self.maintain(files, "prerm", "remove")

    def run(self, *command):
        environment = {**os.environ, "HOME": str(self.root / "home-of-tests"),
                       "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages"),
                       "LD_LIBRARY_PATH": ":".join(str(lib) for lib in self.root.glob("usr/lib/*-*-*"))}
        environment.pop("PV_PLUGIN_PATH", None)
        program = self.root / "usr" / "bin" / command[0]
        words = [str(program) if command[0] in PROGRAMS else command[0]]
        words += [str(self.root / "usr" / "bin" / word) if word in PROGRAMS else word
                  for word in command[1:]]
        run(*words, env=environment)

    def path(self, path):
        return str(self.root / path)


def check_use(system, downstream, menu):
    """The library in C++, the package in Python, the plugin in ParaView."""
    for name in ("Package", "SliceSphere.cxx"):
        copy = shutil.copytree if (downstream / name).is_dir() else shutil.copy
        copy(downstream / name, system.root / "downstream" / name)
    shutil.copy(menu, system.root / "downstream")
    there = system.path("downstream")
    system.run("cmake", "-S", f"{there}/Package", "-B", f"{there}/build", "-Wno-dev",
               "-DCMAKE_BUILD_TYPE=None", *system.options)
    system.run("cmake", "--build", f"{there}/build")
    system.run(f"{there}/build/bin/SliceSphere")
    system.run("/usr/bin/python3", "-c", IMPORTED)
    system.run("pvpython", "-c", LISTED)
    if shutil.which("xvfb-run"):
        # The welcome dialog would wait for somebody.
        settings = system.root / "home-of-tests/.config/ParaView"
        settings.mkdir(parents=True)
        version = re.search(r"\d+\.\d+\.\d+", output_of("pvpython", "--version")).group()
        (settings / f"ParaView{version}.ini").write_text(
            "[General]\nGeneralSettings.ShowWelcomeDialog=false\n", encoding="utf-8")
        system.run("xvfb-run", "-a", "-s", "-noreset -screen 0 1280x1024x24", "paraview", "--dr",
                   f"--test-directory={there}", f"--test-script={there}/{menu.name}", "--exit")


def can_mount():
    """Whether this process may have a mount namespace with an overlay of its own."""
    with tempfile.TemporaryDirectory() as scratch:
        script = (f"mount -t tmpfs tmpfs {scratch} && cd {scratch} && mkdir u w r && "
                  "mount -t overlay overlay -o lowerdir=/,upperdir=u,workdir=w r && "
                  "chroot r dpkg --version")
        return os.geteuid() == 0 and subprocess.run(
            ["unshare", "--mount", "sh", "-c", script], stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, check=False).returncode == 0


def check(system, files, downstream, menu):
    """Installed, used, removed again."""
    (system.root / "downstream").mkdir()
    system.install(files)
    system.install(files)  # a second time changes nothing
    macro = "usr/bin/Macros/Inspect Slices.py"
    assert (system.root / macro).exists(), "ParaView finds no macro"
    check_use(system, downstream, menu)
    # Another plugin stays.
    (system.root / PLUGINS / "Other.so").touch()
    system.remove(files)
    left = os.listdir(system.root / PLUGINS)
    assert left == ["Other.so"], f"{PLUGINS} has {left}"
    assert not os.path.lexists((system.root / macro).parent), "a link to macros that are gone is left"


def main(build, downstream, menu):
    unshared = "--unshared" in sys.argv
    if not unshared and can_mount():
        os.execvp("unshare", ["unshare", "--mount", sys.executable, *sys.argv, "--unshared"])
    with tempfile.TemporaryDirectory() as folder:
        files = make_packages(build, pathlib.Path(folder))
        if unshared:
            # Never removed with what is in it, as devices are: the mounts end with this process.
            scratch = pathlib.Path(tempfile.mkdtemp())
            try:
                check(System(scratch), files, downstream, menu)
            finally:
                run("umount", "--recursive", "--lazy", scratch)
                scratch.rmdir()
        else:
            with tempfile.TemporaryDirectory() as scratch:
                check(Folder(pathlib.Path(scratch)), files, downstream, menu)
    print("packages: all checks passed in", "a clean root" if unshared else "a folder")


main(*(pathlib.Path(word).resolve() for word in sys.argv[1:4]))
