#!/usr/bin/env python3
"""The borders between the modules: who may include and link whom. Run by ctest as test_borders.py ROOT."""

import re
import sys
import unittest
from pathlib import Path

# The modules each one may link; README.md and the CMakeLists.txt of each module must agree.
MODULES = {
    "core": set(),
    "flow": {"core"},
    "motion": {"core"},
    "obstacles": {"core"},
    "pipeline": {"core", "flow", "motion", "obstacles"},
    "mapping": {"core"},
    "sensor": {"pipeline", "mapping"},
    "nav": {"core", "mapping"},
    "sim": {"core"},
    "replay": {"pipeline", "sensor", "mapping"},
    "producer": {"pipeline", "sensor", "replay"},  # libs/sensor/plugin
    "drive": {"nav", "sim", "pipeline", "sensor", "replay", "producer"},
}
MAY_USE_MRPT = {"mapping", "sensor", "nav", "sim", "replay", "producer", "drive"}

# Headers of others, and the linked target that brings them.
LIBRARIES = {
    r"Eigen/": r"Eigen3::Eigen",
    r"EGL/": r"OpenGL::EGL",
    r"GL/": r"OpenGL::OpenGL",
    r"mrpt/hwdrivers/": r"mrpt::hwdrivers",
    r"mrpt/": r"mrpt::\w+",
    r"nanoflann\.hpp": r"nanoflann::nanoflann",
    r"nlohmann/": r"nlohmann_json::nlohmann_json",
    r"sdf/": r"sdformat12::sdformat12",
    r"(gz|ignition)/math": r"sdformat12::sdformat12",
    r"omp\.h": r"OpenMP::OpenMP_CXX",
    r"opencv2/": r"opencv_\w+",
    r"isa-l/": r"isal",
    r"zlib\.h": r"ZLIB::ZLIB",
}
# Of the language, the processor and the system.
OF_THE_SYSTEM = re.compile(
    r"[a-z_]+|\w+intrin\.h|arm_neon\.h|(stddef|stdint)\.h|(dlfcn|fcntl|netdb|poll|sched|unistd)\.h|(netinet|sys)/\w+\.h"
)


def links_of(cmake_text):
    """The targets a module links, from the flownav_library(...) of its CMakeLists.txt."""
    code = re.sub(r"#.*", "", cmake_text)
    library = re.search(r"flownav_library\(([^()]*)\)", code)[1]
    return set(re.findall(r"\b(?:\w+::\w+|opencv_\w+|isal)", library))


def closure(module, links):
    """All that `module` sees: what it links, and what those link in turn."""
    seen, todo = set(), [module]
    while todo:
        for target in links.get(todo.pop(), set()) - seen:
            seen.add(target)
            if target.startswith("flownav::"):
                todo.append(target.removeprefix("flownav::"))
    return seen


def include_fault(module, header, visible):
    if ".." in header:
        return "reaches into another folder"
    own = re.match(r"flownav/(\w+)/", header)
    if own:
        linked = own[1] == module or "flownav::" + own[1] in visible
        return None if linked else "is of a module that is not linked"
    if header.startswith("mrpt/") and module not in MAY_USE_MRPT:
        return "is of MRPT, which this module must not know"
    for pattern, target in LIBRARIES.items():
        if re.match(pattern, header):
            linked = any(re.fullmatch(target, other) for other in visible)
            return None if linked else f"needs a link to {target}"
    return None if OF_THE_SYSTEM.fullmatch(header) else "is of an unknown library: name it in this test"


def faults(links, sources):
    """links: module -> linked targets; sources: (module, file name) -> text. One line a fault."""
    found = []
    for module in sorted(links):
        modules = {t.removeprefix("flownav::") for t in links[module] if t.startswith("flownav::")}
        for other in sorted(modules - MODULES.get(module, set())):
            found.append(f"{module} links {other}, which is not allowed")
    for (module, name), text in sorted(sources.items()):
        visible = closure(module, links)
        for quote, header in re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', text, re.MULTILINE):
            beside = str(Path(name).parent / header)
            local = quote == '"' and ("/" not in header or (module, beside) in sources)
            fault = None if local else include_fault(module, header, visible)
            if fault:
                found.append(f"{name}: {header} {fault}")
    return found


def module_of(cmake_text):
    """The module that a CMakeLists.txt makes with flownav_library(NAME module ...)."""
    return re.search(r"flownav_library\(\s*NAME\s+(\w+)", cmake_text)[1]


def read_tree(root):
    libs = root / "libs"
    links, folders, sources = {}, {}, {}
    for cmake in sorted(libs.rglob("*/CMakeLists.txt")):
        module = module_of(cmake.read_text())
        links[module] = links_of(cmake.read_text())
        folders[cmake.parent] = module
    for file in sorted(libs.rglob("*")):
        if file.suffix in (".h", ".cpp", ".inc"):
            nearest = next(folder for folder in file.parents if folder in folders)
            sources[folders[nearest], str(file.relative_to(root))] = file.read_text()
    return links, sources


class Borders(unittest.TestCase):
    ROOT = Path(__file__).resolve().parents[2]

    def test_no_module_crosses_its_borders(self):
        links, sources = read_tree(self.ROOT)
        self.assertGreater(len(sources), 20)
        self.assertEqual(faults(links, sources), [])

    def test_every_module_is_known_here(self):
        links, _ = read_tree(self.ROOT)
        self.assertLessEqual(set(links), set(MODULES))

    def test_only_the_producer_knows_the_hardware_drivers(self):
        links, _ = read_tree(self.ROOT)
        users = {module for module in links if "mrpt::hwdrivers" in links[module]}
        self.assertEqual(users, {"producer"})

    def test_faults_are_found(self):
        links = {"flow": {"flownav::core"}, "motion": {"flownav::core"}, "core": {"Eigen3::Eigen"}}

        def fault(module, line):
            return len(faults(links, {(module, "a.cpp"): line}))

        self.assertEqual(fault("motion", '#include "flownav/core/field.h"\n#include <Eigen/Core>\n#include <cmath>'), 0)
        self.assertEqual(fault("motion", '#include "local.h"'), 0)
        self.assertEqual(fault("motion", '#include "flownav/flow/params.h"'), 1)
        self.assertEqual(fault("motion", "  # include <flownav/obstacles/params.h>"), 1)
        self.assertEqual(fault("flow", '#include "../../motion/src/robust.h"'), 1)
        self.assertEqual(fault("core", "#include <mrpt/poses/CPose3D.h>"), 1)
        self.assertEqual(fault("core", "#include <opencv2/core.hpp>"), 1)
        self.assertEqual(fault("core", "#include <boost/optional.hpp>"), 1)
        self.assertEqual(len(faults({"flow": {"flownav::motion"}}, {})), 1)
        sensor = {"sensor": {"mrpt::obs"}}
        self.assertEqual(faults(sensor, {("sensor", "a.cpp"): "#include <mrpt/obs/CObservation.h>"}), [])
        self.assertEqual(len(faults(sensor, {("sensor", "a.cpp"): "#include <mrpt/hwdrivers/CCameraSensor.h>"})), 1)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Borders.ROOT = Path(sys.argv.pop(1))
    unittest.main()
