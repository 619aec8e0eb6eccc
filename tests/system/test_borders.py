#!/usr/bin/env python3
"""The order of the modules: who may include and link whom. Run by ctest as test_borders.py ROOT."""

import re
import sys
import unittest
from pathlib import Path

# A module may include and link only what stands left of it, and itself: share/doc/architecture.md shows why.
ORDER = [
    {"math"},
    {"core"},
    {"flow", "motion", "obstacles", "mapping", "sim"},
    {"pipeline", "nav"},
    {"config"},
    {"io"},
    {"cli"},
    {"evaluation", "drive"},
    {"report"},
    {"replay"},
    {"calibration", "regress"},
    {"apps"},
]
PLACE = {module: place for place, modules in enumerate(ORDER) for module in modules}
NEVER_MRPT = {"math", "core", "flow", "motion", "obstacles", "pipeline"}
# The names of math and core stand in flownav itself, and so do classes that archives name.
NAMESPACES_OF_FLOWNAV = {"math", "core"}
SERIALIZED = re.compile(r"flow_field_|flow_obstacle_sensor|register")

# Headers of others, and the linked target that brings them.
LIBRARIES = {
    r"Eigen/": r"Eigen3::Eigen",
    r"EGL/": r"OpenGL::EGL",
    r"GL/": r"OpenGL::OpenGL",
    r"mrpt/3rdparty/tclap/": r"mrpt::tclap",
    r"mrpt/hwdrivers/": r"mrpt::hwdrivers",
    r"mrpt/": r"mrpt::\w+",
    r"nanoflann\.hpp": r"nanoflann::nanoflann",
    r"nlohmann/": r"nlohmann_json::nlohmann_json",
    r"sdf/": r"sdformat12::sdformat12",
    r"(gz|ignition)/math": r"sdformat12::sdformat12",
    r"omp\.h": r"OpenMP::OpenMP_CXX",
    r"opencv2/": r"opencv_\w+",
    r"openssl/": r"OpenSSL::Crypto",
    r"tinyxml2\.h": r"tinyxml2::tinyxml2",
    r"isa-l/": r"isal",
    r"libav(codec|format|util)/": r"av(codec|format|util)",
    r"libswscale/": r"swscale",
    r"zlib\.h": r"ZLIB::ZLIB",
}
# Of the language, the processor and the system.
OF_THE_SYSTEM = re.compile(
    r"[a-z_]+|\w+intrin\.h|arm_neon\.h|(stddef|stdint)\.h|(dlfcn|fcntl|netdb|poll|sched|signal|unistd)\.h"
    r"|(netinet|sys)/\w+\.h"
)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def libraries_in(cmake_text):
    """name -> linked targets, of every flownav_library(...) in a CMakeLists.txt."""
    code = re.sub(r"#.*", "", cmake_text)
    found = {}
    for body in re.findall(r"flownav_library\(((?:[^()]|\([^()]*\))*)\)", code):
        name = re.search(r"NAME\s+(\w+)", body)[1]
        found[name] = set(re.findall(r"\b(?:\w+::\w+|opencv_\w+|isal|av(?:codec|format|util)|swscale)\b", body))
    return found


def closure(library, links):
    """All that `library` sees: what it links, and what those link in turn."""
    seen, todo = set(), [library]
    while todo:
        for target in links.get(todo.pop(), set()) - seen:
            seen.add(target)
            if target.startswith("flownav::"):
                todo.append(target.removeprefix("flownav::"))
    return seen


def points_upward(module, other):
    return other != module and PLACE.get(other, len(ORDER)) >= PLACE[module]


def include_fault(module, header, visible):
    if ".." in header:
        return "reaches into another folder"
    own = re.match(r"flownav/(\w+)/", header)
    if own:
        return "points upward in the order of the modules" if points_upward(module, own[1]) else None
    if header.startswith("mrpt/") and module in NEVER_MRPT:
        return "is of MRPT, which this module must not know"
    for pattern, target in LIBRARIES.items():
        if re.match(pattern, header):
            linked = any(re.fullmatch(target, other) for other in visible)
            return None if linked else f"needs a link to {target}"
    return None if OF_THE_SYSTEM.fullmatch(header) else "is of an unknown library: name it in this test"


def include_faults(module, name, text, visible):
    for quote, header in INCLUDE.findall(text):
        if quote == '"' and not header.startswith("flownav/") and ".." not in header:
            continue  # a header of the same module: the compiler finds it or fails
        fault = include_fault(module, header, visible)
        if fault:
            yield f"{name}: {header} {fault}"


def namespace_fault(module, name, text):
    """A fault when a file of a module declares names in the namespace of another."""
    if module in NAMESPACES_OF_FLOWNAV or module == "apps" or SERIALIZED.search(name):
        return None
    others = [n for n in re.findall(r"^namespace (flownav[\w:]*) \{", text, re.MULTILINE)
              if n != f"flownav::{module}" and not n.startswith(f"flownav::{module}::")]
    return f"{name}: declares in {others[0]}, not in flownav::{module}" if others else None


def link_faults(links, module_of_library):
    for library in sorted(links):
        module = module_of_library[library]
        for target in sorted(t for t in links[library] if t.startswith("flownav::")):
            other = module_of_library.get(target.removeprefix("flownav::"))
            if other is None or points_upward(module, other):
                yield f"{library} links {target}, which does not stand left of {module}"


def read_tree(root):
    """links: library -> targets; module_of_library; sources: (module, library, file name) -> text."""
    libs = root / "libs"
    links, modules, folders, sources = {}, {}, {}, {}
    for cmake in sorted(libs.rglob("*/CMakeLists.txt")):
        found = libraries_in(cmake.read_text())
        module = cmake.relative_to(libs).parts[0]
        links.update(found)
        modules.update({name: module for name in found})
        folders[cmake.parent] = set(found)
    for file in sorted(libs.rglob("*")):
        if file.suffix in (".h", ".cpp", ".inc"):
            nearest = next(folder for folder in file.parents if folder in folders)
            sources[file.relative_to(libs).parts[0], str(file.relative_to(root))] = (folders[nearest], file.read_text())
    return links, modules, sources


class Borders(unittest.TestCase):
    ROOT = Path(__file__).resolve().parents[2]

    def test_no_include_and_no_link_points_upward(self):
        links, modules, sources = read_tree(self.ROOT)
        self.assertGreater(len(sources), 300)
        faults = list(link_faults(links, modules))
        for (module, name), (libraries, text) in sources.items():
            visible = set().union(*(closure(library, links) for library in libraries))
            faults += include_faults(module, name, text, visible)
        self.assertEqual(faults, [])

    def test_every_module_has_its_place_and_its_namespace(self):
        _, modules, sources = read_tree(self.ROOT)
        self.assertEqual(set(modules.values()), set(PLACE) - {"apps"})
        faults = [namespace_fault(module, name, text) for (module, name), (_, text) in sources.items()]
        self.assertEqual([fault for fault in faults if fault], [])

    def test_public_headers_stand_under_the_name_of_their_module(self):
        _, _, sources = read_tree(self.ROOT)
        for module, name in sources:
            if "/include/" in name:
                self.assertTrue(re.match(rf"libs/{module}/(\w+/)?include/flownav/{module}/", name), name)

    def test_only_what_is_live_knows_the_hardware_drivers(self):
        links, _, _ = read_tree(self.ROOT)
        self.assertEqual({name for name in links if "mrpt::hwdrivers" in links[name]}, {"live"})

    def test_the_page_on_the_architecture_shows_the_same_order(self):
        page = (self.ROOT / "share/doc/architecture.md").read_text()
        block = re.search(r"^    math \| core.*\n(?:    .*\n)*", page, re.MULTILINE)[0]
        self.assertEqual([set(re.findall(r"\w+", part)) for part in block.split("|")], ORDER)

    def test_faults_are_found(self):
        def fault(module, line, visible=frozenset()):
            return len(list(include_faults(module, "a.cpp", line, visible)))

        self.assertEqual(fault("motion", '#include "flownav/core/field.h"\n#include <cmath>\n#include "local.h"'), 0)
        self.assertEqual(fault("motion", "#include <Eigen/Core>", {"Eigen3::Eigen"}), 0)
        self.assertEqual(fault("motion", '#include "flownav/flow/params.h"'), 1)
        self.assertEqual(fault("motion", "  # include <flownav/obstacles/params.h>"), 1)
        self.assertEqual(fault("math", '#include "flownav/core/field.h"'), 1)
        self.assertEqual(fault("flow", '#include "../../motion/src/robust.h"'), 1)
        self.assertEqual(fault("core", "#include <mrpt/poses/CPose3D.h>", {"mrpt::poses"}), 1)
        self.assertEqual(fault("core", "#include <opencv2/core.hpp>"), 1)
        self.assertEqual(fault("core", "#include <boost/optional.hpp>"), 1)
        self.assertEqual(fault("io", "#include <mrpt/hwdrivers/CCameraSensor.h>", {"mrpt::obs"}), 1)
        modules = {"flow": "flow", "flow_opencv": "flow", "motion": "motion", "live": "io", "io": "io"}
        self.assertEqual(len(list(link_faults({"flow": {"flownav::motion"}}, modules))), 1)
        self.assertEqual(len(list(link_faults({"flow_opencv": {"flownav::flow"}, "live": {"flownav::io"}}, modules))), 0)
        self.assertIsNotNone(namespace_fault("motion", "a.h", "namespace flownav {\n"))
        self.assertIsNotNone(namespace_fault("motion", "a.h", "namespace flownav::flow {\n"))
        self.assertIsNone(namespace_fault("motion", "a.h", "namespace flownav::motion {\n"))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Borders.ROOT = Path(sys.argv.pop(1))
    unittest.main()
