#!/usr/bin/python3
"""The package in other people's catkin workspaces: configured beside a package that has the same names,
without tests as a packager does it, and with clang. Nothing is built."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOPLEVEL = "/usr/share/catkin/cmake/toplevel.cmake"
NEIGHBOUR = """cmake_minimum_required(VERSION 3.16)
project(neighbour)
find_package(catkin REQUIRED)
catkin_package()
foreach(NAME replay mapping frontend place_recognition benchmarks util_test map_images)
  add_executable(${NAME} main.cc)
endforeach()
"""
MANIFEST = """<package format="2"><name>neighbour</name><version>0.1.0</version>
<description>A neighbour.</description><maintainer email="a@example.org">A</maintainer><license>BSD</license>
<buildtool_depend>catkin</buildtool_depend></package>
"""


class WorkspaceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="rovio_sfm_workspace_")
        self.addCleanup(folder.cleanup)
        self.workspace = pathlib.Path(folder.name)
        neighbour = self.workspace / "src/neighbour"
        neighbour.mkdir(parents=True)
        (self.workspace / "src/CMakeLists.txt").symlink_to(TOPLEVEL)
        (self.workspace / "src/rovio_sfm").symlink_to(ROOT)
        (neighbour / "CMakeLists.txt").write_text(NEIGHBOUR)
        (neighbour / "package.xml").write_text(MANIFEST)
        (neighbour / "main.cc").write_text("int main() {}\n")

    def configure(self, *options):
        """As catkin_make does; returns the commands and the cache of the build."""
        build = self.workspace / "build"
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("PYTHONHOME", "PYTHONPATH", "VIRTUAL_ENV", "CMAKE_PREFIX_PATH",
                                       "CXX", "CC")}
        environment["PATH"] = "/usr/bin:/usr/sbin:/bin:" + environment.get("PATH", "")
        done = subprocess.run(
            ["cmake", "-S", self.workspace / "src", "-B", build, "-G", "Ninja",
             f"-DCATKIN_DEVEL_PREFIX={self.workspace / 'devel'}",
             f"-DCMAKE_INSTALL_PREFIX={self.workspace / 'install'}", *options],
            capture_output=True, text=True, env=environment, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-3000:])
        commands = subprocess.run(["ninja", "-C", build, "-t", "commands", "all"], capture_output=True,
                                  text=True, check=True).stdout
        self.assertIn("src/nodes/mapping_main.cc", commands)
        self.assertNotIn("-Werror", commands)
        return commands, (build / "CMakeCache.txt").read_text()

    def test_beside_a_package_with_the_same_names(self):
        commands, cache = self.configure()
        self.assertIn("neighbour", commands)
        self.assertNotIn("_test.cc", commands)  # `all` of a workspace builds no tests
        self.assertNotRegex(cache, r"(?m)^CMAKE_BUILD_TYPE:\w+=.+")
        self.assertNotRegex(cache, r"(?m)^CCACHE_PROGRAM:")

    def test_without_tests(self):
        self.configure("-DCATKIN_ENABLE_TESTING=OFF")
        targets = subprocess.run(["ninja", "-C", self.workspace / "build", "-t", "targets", "all"],
                                 capture_output=True, text=True, check=True).stdout
        self.assertIsNone(re.search(r"(?m)^rovio_sfm_\w+_test: ", targets))

    @unittest.skipUnless(shutil.which("clang++-14"), "clang 14 is not installed")
    def test_with_clang(self):
        commands, _ = self.configure("-DCMAKE_CXX_COMPILER=clang++-14", "-DCMAKE_C_COMPILER=clang-14")
        self.assertIn("clang++-14", commands)


if __name__ == "__main__":
    unittest.main()
